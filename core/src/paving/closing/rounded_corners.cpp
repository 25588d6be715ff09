// In: a loop. Out: elements, and the loop without the corner.
//
//        m
//      a   b        The loop runs y -> a -> m -> b -> x; then y -> p -> x.
//     y  q  x       The quads are (y, a, q, p), (q, b, x, p) and (a, m, b, q).
//        p
#include "paving/closing/rounded_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
constexpr double shorter = 0.25;  // of the shorter facet beside them: the two facets of a corner
constexpr double least_bend = 50 * deg, most_bend = 130 * deg;  // of all three nodes
constexpr double straight = 30 * deg;                           // the nodes beside them bend by less
constexpr double smooth = 150 * deg;                            // interior angle: no element's corner
constexpr double depth = 0.42;           // of the width between the sides: so far behind it lies the node within
constexpr double room = 0.5;             // of the corner's depth: nothing else lies so near behind it
constexpr std::size_t fewest_nodes = 8;  // of a loop that has more than its corners

class RoundedCorners {
 public:
  RoundedCorners(const Region& region, RegionMesh& mesh, std::vector<LoopNode>& loop, std::vector<int>& nodes,
                 const std::vector<Vec2>& others)
      : region_(region), mesh_(mesh), loop_(loop), nodes_(nodes), others_(others) {}

  void lay() {
    const std::vector<Corner> found = corners();
    for (std::size_t i = 0, n = found.size(); i < n; ++i) {
      // Sides of two facets between such corners are left to rows.
      const bool is_alone =
          n < 2 || (found[i].at[0] != found[(i + n - 1) % n].at[4] && found[i].at[4] != found[(i + 1) % n].at[0]);
      if (is_alone && nodes_.size() >= fewest_nodes) fill(found[i]);
    }
  }

 private:
  struct Corner {
    std::array<int, 5> at;  // as drawn: y, a, m, b, x
    bool is_smooth;         // at m
  };

  int at(std::size_t i) const { return nodes_[i % nodes_.size()]; }
  double chord(std::size_t i) const { return norm(mesh_.x[at(i + 1)] - mesh_.x[at(i)]); }

  /// To the left, at a node of the loop; by chords.
  double bend(std::size_t i) const {
    const MetricFrame frame = mesh_.frame(at(i));
    const Vec3 x = mesh_.x[at(i)];
    const Vec2 in = frame.of({x - mesh_.x[at(i + nodes_.size() - 1)], {}}),
               out = frame.of({mesh_.x[at(i + 1)] - x, {}});
    return std::atan2(cross(in, out), dot(in, out));
  }

  /// In the order of the loop, of which nothing is taken off yet.
  std::vector<Corner> corners() const {
    std::vector<Corner> found;
    for (std::size_t i = 0, n = nodes_.size(); n >= fewest_nodes && i < n; ++i) {
      if (chord(i + 1) + chord(i + 2) > shorter * std::min(chord(i), chord(i + 3))) continue;
      const double all = bend(i + 1) + bend(i + 2) + bend(i + 3);
      if (all < least_bend || all > most_bend) continue;
      if (std::min({bend(i + 1), bend(i + 2), bend(i + 3)}) < 0) continue;
      if (std::max(std::fabs(bend(i)), std::fabs(bend(i + 4))) > straight) continue;
      found.push_back({{at(i), at(i + 1), at(i + 2), at(i + 3), at(i + 4)}, loop_[(i + 2) % n].angle > smooth});
    }
    return found;
  }

  void fill(const Corner& corner) {
    const auto [y, a, m, b, x] = corner.at;
    const auto first = std::ranges::find(nodes_, y);
    if (first == nodes_.end()) return;
    std::rotate(loop_.begin(), loop_.begin() + (first - nodes_.begin()), loop_.end());
    std::rotate(nodes_.begin(), first, nodes_.end());
    if (!std::ranges::equal(corner.at, std::span(nodes_).first(corner.at.size()))) return;
    const std::vector<Vec2>& p = mesh_.p;
    const Vec2 between = 0.5 * (p[a] + p[b]), opposite = p[x] + p[y] - p[m];
    const Vec2 inward = opposite - between,
               inner = between + depth * norm(mesh_.x[b] - mesh_.x[a]) /
                                     norm(mesh_.x[x] + mesh_.x[y] - mesh_.x[m] - 0.5 * (mesh_.x[a] + mesh_.x[b])) *
                                     inward;
    if (!turns_left({p[a], p[m], p[b], inner}) || !turns_left({p[y], p[a], inner, opposite}) ||
        !turns_left({inner, p[b], p[x], opposite}))
      return;
    const std::array outline{p[y], p[a], p[m], p[b], p[x], opposite + room * inward};
    if (std::ranges::any_of(others_, [&](Vec2 other) { return is_inside(outline, other); })) return;
    const int q = add_node(region_, inner, mesh_), node = add_node(region_, opposite, mesh_);
    mesh_.is_fixed[q] = true;  // clean-up joined the two triangles again
    if (corner.is_smooth) {
      mesh_.add_element({a, m, q, -1});
      mesh_.add_element({m, b, q, -1});
    } else {
      mesh_.add_element({a, m, b, q});
    }
    mesh_.add_element({y, a, q, node});
    mesh_.add_element({q, b, x, node});
    nodes_.erase(nodes_.begin() + 1, nodes_.begin() + 3);
    loop_.erase(loop_.begin() + 1, loop_.begin() + 3);
    nodes_[1] = node, loop_[1] = {};
  }

  static bool turns_left(const std::array<Vec2, 4>& quad) {
    for (std::size_t k = 0; k < 4; ++k)
      if (orientation(quad[k], quad[(k + 1) % 4], quad[(k + 2) % 4]) <= 0) return false;
    return true;
  }

  const Region& region_;
  RegionMesh& mesh_;
  std::vector<LoopNode>& loop_;
  std::vector<int>& nodes_;
  const std::vector<Vec2>& others_;
};

}  // namespace

void lay_rounded_corners(const Region& region, RegionMesh& mesh, std::vector<LoopNode>& loop, std::vector<int>& nodes,
                         const std::vector<Vec2>& others) {
  RoundedCorners(region, mesh, loop, nodes, others).lay();
}

}  // namespace paver
