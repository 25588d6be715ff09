// Edges inside a face become part of its loops: a loop that comes to such an edge walks along one side of it and, from
// its end, back along the other. At every vertex of these edges the loops are linked anew: each coedge is followed by
// the first one that a turn to the left of it meets. A pole is a line in (u, v), which an edge that ends at the pole
// divides: there turns are those in (u, v), between what meets in one place of the line.
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "brep/surfaces/evaluators_impl.h"
#include "topology/build_parts_impl.h"
#include "topology/corner_angle.h"

namespace paver {
namespace {

/// Directions are taken to a point this share of the edge away from its end: near enough for the angle, far enough to
/// tell edges that leave in the same direction.
constexpr double step_share = 0.01;
/// Places on a pole's line nearer than this share of it are one.
constexpr double place_share = 1e-6;

class SlitLinker : CoedgeWalker {
 public:
  SlitLinker(const Surface& surface, const std::vector<Edge>& edges, std::vector<Loop>& loops)
      : CoedgeWalker(edges), surface_(surface), loops_(loops) {}

  int run(const std::vector<Coedge>& inner) {
    add_loops();
    int skipped = 0;
    std::set<int> touched, poles;
    for (const Coedge& c : inner) {
      if (!divide_pole_at(c, 0, poles) || !divide_pole_at(c, 1, poles)) {
        ++skipped;
        continue;
      }
      add_both_sides(c);
      touched.insert({edge(c).start, edge(c).end});
    }
    for (int vertex : touched) link_at(vertex, poles.contains(vertex));
    chain();
    return skipped;
  }

 private:
  const Coedge& side(int i) const { return sides_[i]; }

  void add_loops() {
    for (const Loop& loop : loops_) {
      int first = static_cast<int>(sides_.size()), count = static_cast<int>(loop.coedges.size());
      for (int i = 0; i < count; ++i) {
        sides_.push_back(loop.coedges[i]);
        next_.push_back(first + (i + 1) % count);
      }
    }
  }

  /// False where the edge ends at a pole but not on its line.
  bool divide_pole_at(const Coedge& c, double end_share, std::set<int>& poles) {
    const int vertex = end_share > 0.5 ? end(c) : start(c);
    const Vec2 uv = uv_at(c, end_share);
    bool is_pole = false;
    for (int i = 0, n = static_cast<int>(sides_.size()); i < n; ++i) {
      if (!edge(side(i)).is_degenerate || start(side(i)) != vertex) continue;
      is_pole = true;
      const Vec2 a = uv_at(side(i), 0), b = uv_at(side(i), 1), along = b - a;
      const double length2 = dot(along, along), share = dot(uv - a, along) / length2;
      if (!(length2 > 0) || share < -place_share || share > 1 + place_share) continue;
      if (norm(a + share * along - uv) > place_share * std::sqrt(length2)) continue;
      poles.insert(vertex);
      if (share > place_share && share < 1 - place_share) divide_pole(i, uv);
      return true;
    }
    return !is_pole;
  }

  void divide_pole(int i, Vec2 uv) {
    const Vec2 a = uv_at(side(i), 0), b = uv_at(side(i), 1);
    Coedge rest = side(i);
    set_line(sides_[i], a, uv);
    set_line(rest, uv, b);
    next_.push_back(std::exchange(next_[i], static_cast<int>(sides_.size())));
    sides_.push_back(std::move(rest));
  }

  void set_line(Coedge& c, Vec2 a, Vec2 b) const {
    if (c.is_reversed) std::swap(a, b);
    c.pcurve = make_straight_parameter_curve(a, b, edge(c).t0, edge(c).t1);
  }

  void add_both_sides(const Coedge& c) {
    for (bool is_reversed : {false, true}) {
      sides_.push_back(c);
      sides_.back().is_reversed = is_reversed;
      sides_.back().is_slit = true;
      next_.push_back(-1);
    }
  }

  void link_at(int vertex, bool is_pole) {
    std::vector<int> in, out;
    for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
      if (end(side(i)) == vertex) in.push_back(i);
      if (start(side(i)) == vertex) out.push_back(i);
    }
    for (int i : in) {
      double least = 10;
      for (int o : out) {
        if (is_pole && !is_same_place(side(i), side(o))) continue;
        double angle = is_pole ? turn_in_uv(side(i), side(o)) : turn(side(i), side(o));
        if (angle < least) least = angle, next_[i] = o;
      }
    }
  }

  bool is_same_place(const Coedge& in, const Coedge& out) const {
    const double size = std::max(norm(uv_at(in, 1) - uv_at(in, 0)), norm(uv_at(out, 1) - uv_at(out, 0)));
    return norm(uv_at(in, 1) - uv_at(out, 0)) <= 4 * place_share * size;
  }

  static bool is_way_back(const Coedge& in, const Coedge& out) {
    return in.edge == out.edge && in.is_reversed != out.is_reversed;
  }

  double turn_in_uv(const Coedge& in, const Coedge& out) const {
    if (is_way_back(in, out)) return 2 * M_PI;
    const Vec2 back = uv_at(in, 1 - step_share) - uv_at(in, 1), ahead = uv_at(out, step_share) - uv_at(out, 0);
    return angle_to_left(ahead, back);
  }

  /// Angle of the face between the end of `in` and the start of `out`, radians in (0, 2 pi]: all around where `out` is
  /// the way back.
  double turn(const Coedge& in, const Coedge& out) const {
    if (is_way_back(in, out) && start(in) != end(in)) return 2 * M_PI;
    Vec3 normal = surface_.normal(uv_at(in, 1)), back = direction(in, 1), ahead = direction(out, 0);
    double angle = std::atan2(dot(normal, cross(ahead, back)), dot(ahead, back));
    return angle > 0 ? angle : angle + 2 * M_PI;
  }

  Vec3 direction(const Coedge& c, double from) const {
    const Curve& curve = *edge(c).curve;
    return unit(curve.point(parameter(c, from + (from > 0.5 ? -step_share : step_share))) -
                curve.point(parameter(c, from)));
  }

  void chain() {
    std::vector<bool> is_done(sides_.size(), false);
    loops_.clear();
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (is_done[i]) continue;
      Loop& loop = loops_.emplace_back();
      for (std::size_t j = i; !is_done[j]; j = static_cast<std::size_t>(next_[j])) {
        is_done[j] = true;
        loop.coedges.push_back(sides_[j]);
      }
    }
  }

  const Surface& surface_;
  std::vector<Loop>& loops_;
  std::vector<Coedge> sides_;
  std::vector<int> next_;  ///< per side
};

}  // namespace

int add_slits(const Surface& surface, const std::vector<Edge>& edges, const std::vector<Coedge>& inner,
              std::vector<Loop>& loops) {
  return SlitLinker(surface, edges, loops).run(inner);
}

}  // namespace paver
