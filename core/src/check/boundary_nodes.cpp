#include <algorithm>

#include "base/segment.h"
#include "check/checked_mesh.h"
#include "check/vector_area.h"

namespace paver {
namespace {

constexpr double off_curve = 1e-6;  // of the chord

/// One interval of an edge, with the mesh's line on it.
class Interval {
 public:
  Interval(const CheckedMesh& checked, int edge, int interval, std::size_t line) : edge_(checked.model.edges[edge]) {
    const EdgeDivision& division = checked.edges.edges[edge];
    const std::size_t first = 2 * static_cast<std::size_t>(interval);
    const auto v = checked.mesh.line(line);
    is_curved_ = checked.mesh.order > 1;
    target_length_ = checked.target_length;
    a_ = checked.mesh.nodes[v[0]], b_ = checked.mesh.nodes[v[1]], m_ = checked.mesh.nodes[v[is_curved_ ? 2 : 0]];
    std::copy_n(division.t.begin() + static_cast<long>(first), 3, t_);
    is_first_ = interval == 0, is_last_ = interval + 1 == division.intervals();
    const std::vector<Vec3>& vertices = checked.model.vertices;
    start_ = is_first_ ? vertices[edge_.start] : edge_.curve->point(t_[0]);
    end_ = is_last_ ? vertices[edge_.end] : edge_.curve->point(t_[2]);
    middle_ = edge_.curve->point(t_[1]);
  }

  Vec3 where() const { return 0.5 * (a_ + b_); }

  long nodes_off() const {
    const double most = off_curve * norm(b_ - a_);
    return !(norm(a_ - start_) <= most) + (is_last_ && !(norm(b_ - end_) <= most)) +
           (is_curved_ && !(distance_to_way() <= most));
  }

  /// Where the curve does not end at its vertex the middle may be between.
  bool is_far() const {
    const double aside = norm(start_ - edge_.curve->point(t_[0])) + norm(end_ - edge_.curve->point(t_[2]));
    return is_curved_ && !(norm(m_ - middle_) <= most_off_moved * target_length_ + 0.5 * aside);
  }

  /// Between the mesh's line and the curve.
  double area() const {
    const Vec3 o = a_, m = middle_ - o, b = b_ - o;
    const Vec3 first = edge_.curve->point(0.5 * (t_[0] + t_[1])) - o,
               second = edge_.curve->point(0.5 * (t_[1] + t_[2])) - o;
    const Vec3 exact = swept({}, first, m) + swept(m, second, b);
    return 0.5 * norm(exact - (is_curved_ ? swept({}, m_ - o, b) : Vec3{}));
  }

  /// Between the curve and its image on a face.
  double area_off(const Face& face, const ParameterCurve& image) const {
    return norm(face.surface->point(image.uv(t_[1])) - middle_) * norm(b_ - a_);
  }

 private:
  /// Of the middle node from the way between the curve's middle and the chord's.
  double distance_to_way() const { return distance_to_segment(m_, middle_, where()); }

  const Edge& edge_;
  bool is_curved_, is_first_, is_last_;
  Vec3 a_, b_, m_;             ///< of the mesh: ends and middle
  Vec3 start_, end_, middle_;  ///< where they should be
  double t_[3];
  double target_length_;
};

}  // namespace

void check_boundary_nodes(const CheckedMesh& checked, const Ranks& ranks, MeshFaults& faults, AreaSlack& slack) {
  const std::vector<int>& line_edge = checked.mesh.line_edge;
  for (std::size_t f = 0; f < checked.model.faces.size(); ++f) {
    if (!checked.is_meshed[f] || static_cast<int>(f) % ranks.count() != ranks.rank()) continue;
    const Face& face = checked.model.faces[f];
    for (const Coedge& coedge : coedges_of(face.loops)) {
      auto [first, last] = std::equal_range(line_edge.begin(), line_edge.end(), coedge.edge);
      for (auto line = first; line != last; ++line) {
        const Interval interval(checked, coedge.edge, static_cast<int>(line - first),
                                static_cast<std::size_t>(line - line_edge.begin()));
        for (long n = interval.nodes_off(); n > 0; --n)
          faults.add(static_cast<int>(f), FaultKind::off_edge, interval.where());
        if (interval.is_far()) faults.add(static_cast<int>(f), FaultKind::chord, interval.where());
        slack.add(static_cast<int>(f), interval.area());
        if (coedge.pcurve) slack.add(static_cast<int>(f), interval.area_off(face, *coedge.pcurve));
      }
    }
  }
}

}  // namespace paver
