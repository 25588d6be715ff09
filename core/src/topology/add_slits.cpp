// Edges inside a face become part of its loops: a loop that comes to such an edge walks along one side of it and, from
// its end, back along the other. At every vertex of these edges the loops are linked anew: each coedge is followed by
// the first one that a turn to the left of it meets.
#include <algorithm>
#include <cmath>
#include <set>

#include "topology/build_parts_impl.h"

namespace paver {
namespace {

/// Directions are taken to a point this share of the edge away from its end: near enough for the angle, far enough to
/// tell edges that leave in the same direction.
constexpr double step_share = 0.01;

class SlitLinker : CoedgeWalker {
 public:
  SlitLinker(const Surface& surface, const std::vector<Edge>& edges, std::vector<Loop>& loops)
      : CoedgeWalker(edges), surface_(surface), loops_(loops) {}

  int run(const std::vector<Coedge>& inner) {
    std::set<int> poles;
    for (const Loop& loop : loops_)
      for (const Coedge& c : loop.coedges)
        if (edge(c).is_degenerate) poles.insert(edge(c).start);
    int skipped = 0;
    add_loops();
    std::set<int> touched;
    for (const Coedge& c : inner) {
      if (poles.count(edge(c).start) || poles.count(edge(c).end)) {
        ++skipped;
        continue;
      }
      add_both_sides(c);
      touched.insert({edge(c).start, edge(c).end});
    }
    for (int vertex : touched) link_at(vertex);
    chain();
    return skipped;
  }

 private:
  const Coedge& side(int i) const { return sides_[static_cast<std::size_t>(i)]; }

  void add_loops() {
    for (const Loop& loop : loops_) {
      int first = static_cast<int>(sides_.size()), count = static_cast<int>(loop.coedges.size());
      for (int i = 0; i < count; ++i) {
        sides_.push_back(loop.coedges[static_cast<std::size_t>(i)]);
        next_.push_back(first + (i + 1) % count);
      }
    }
  }

  void add_both_sides(const Coedge& c) {
    for (bool is_reversed : {false, true}) {
      sides_.push_back(c);
      sides_.back().is_reversed = is_reversed;
      sides_.back().is_slit = true;
      next_.push_back(-1);
    }
  }

  void link_at(int vertex) {
    std::vector<int> in, out;
    for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
      if (end(side(i)) == vertex) in.push_back(i);
      if (start(side(i)) == vertex) out.push_back(i);
    }
    for (int i : in) {
      double least = 10;
      for (int o : out) {
        double angle = turn(side(i), side(o));
        if (angle < least) least = angle, next_[static_cast<std::size_t>(i)] = o;
      }
    }
  }

  /// Angle of the face between the end of `in` and the start of `out`, radians in (0, 2 pi]: all around where `out` is
  /// the way back.
  double turn(const Coedge& in, const Coedge& out) const {
    if (in.edge == out.edge && in.is_reversed != out.is_reversed && start(in) != end(in)) return 2 * M_PI;
    Vec3 x, xu, xv;
    surface_.d1(uv_at(in, 1), x, xu, xv);
    Vec3 normal = unit(cross(xu, xv)), back = direction(in, 1), ahead = direction(out, 0);
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
