#include "repair/shared_sides.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "curving/near_surface.h"
#include "repair/edits/patch.h"

namespace paver {
namespace {

/// Intervals of the edges that bound regions, by their nodes.
std::set<std::pair<int, int>> intervals_of(std::span<const Region> regions, const EdgeNodes& nodes) {
  std::set<int> edges;
  for (const Region& region : regions)
    for (const auto& loop : region.loops)
      for (const LoopNode& node : loop)
        if (node.edge >= 0) edges.insert(node.edge);
  std::set<std::pair<int, int>> intervals;
  for (int edge : edges) {
    const std::vector<int>& along = nodes.edges[static_cast<std::size_t>(edge)].node;
    for (std::size_t i = 1; i < along.size(); ++i) intervals.insert(std::minmax(along[i - 1], along[i]));
  }
  return intervals;
}

class SideDivider {
 public:
  SideDivider(const Region& region, RegionMesh& mesh) : region_(region), mesh_(mesh) {}

  void divide(int a, int b) {
    const int e = mesh_.across(b, a), other = mesh_.across(a, b);
    if (e < 0 || other < 0) return;
    const Vec2 halfway = 0.5 * (mesh_.p[a] + mesh_.p[b]);
    if (divide(e, other, a, b, halfway)) return;
    // In a polar chart that lies beside the side, by more than a thin element is wide.
    const Vec3 middle = 0.5 * (mesh_.x[a] + mesh_.x[b]);
    Vec2 nearest = halfway;
    nearest_point(region_, nearest, middle, norm(mesh_.x[b] - mesh_.x[a]));
    divide(e, other, a, b, nearest);
  }

  std::vector<Vec3> take_made() { return std::move(made_); }

 private:
  bool divide(int e, int other, int a, int b, Vec2 p) {
    const int middle = mesh_.add_node(region_.place(p), 0.5 * (mesh_.h[a] + mesh_.h[b]));
    const auto here = best_of(mesh_.elements[e], a, b, middle), there = best_of(mesh_.elements[other], b, a, middle);
    if (!here || !there) {
      mesh_.drop_last_node();
      return false;
    }
    mesh_.remove_element(e);
    mesh_.remove_element(other);
    for (const auto& elements : {*here, *there})
      for (const Corners& corners : elements) mesh_.add_element(corners);
    made_.push_back(mesh_.x[middle]);
    return true;
  }

  /// The element with a node between its corners a and b: the better of two ways, if one has positive elements only.
  std::optional<std::array<Corners, 2>> best_of(const Element& e, int a, int b, int middle) const {
    std::optional<std::array<Corners, 2>> best;
    double most = 0;
    const int c = e.after(b), d = e.before(a);
    std::array<std::array<Corners, 2>, 2> ways{
        {{{{a, middle, d, -1}, {middle, b, c, d}}}, {{{middle, b, c, -1}, {a, middle, c, d}}}}};
    if (e.corners() == 3)
      ways = {{{{{a, middle, c, -1}, {middle, b, c, -1}}}, {{{a, middle, c, -1}, {middle, b, c, -1}}}}};
    for (const auto& way : ways) {
      double worst = 1;
      for (const Corners& corners : way) worst = std::min(worst, positive_jacobian(mesh_, corners));
      if (worst > most) most = worst, best = way;
    }
    return best;
  }

  const Region& region_;
  RegionMesh& mesh_;
  std::vector<Vec3> made_;
};

}  // namespace

std::vector<InnerSide> inner_sides(const RegionMesh& mesh, int part, int boundary_nodes) {
  std::vector<InnerSide> sides;
  auto is_shared = [&](int v) { return mesh.global[v] >= 0 && mesh.global[v] < boundary_nodes; };
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    for (int k = 0, n = e.corners(); k < n; ++k) {
      const int a = e.v[k], b = e.v[(k + 1) % n];
      if (!is_shared(a) || !is_shared(b) || mesh.global[a] >= mesh.global[b] || mesh.across(a, b) < 0) continue;
      sides.push_back({mesh.global[a], mesh.global[b], part, a, b});
    }
  }
  return sides;
}

std::vector<InnerSide> twin_sides(const RegionMesh& mesh) {
  std::vector<std::pair<int, int>> copies;  // node of the boundary stage, node
  for (int v = 0; v < mesh.node_count(); ++v)
    if (mesh.global[v] >= 0) copies.emplace_back(mesh.global[v], v);
  std::sort(copies.begin(), copies.end());
  std::vector<InnerSide> sides;
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const auto [global, v] = copies[i];
    const bool has_twin =
        (i > 0 && copies[i - 1].first == global) || (i + 1 < copies.size() && copies[i + 1].first == global);
    if (!has_twin) continue;
    for (int e : mesh.star[v]) {
      const int w = mesh.elements[e].after(v);
      if (mesh.global[w] < 0) sides.push_back({global, w, -1, v, w});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<InnerSide> twins;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high && sides[i].a != sides[i - 1].a)
      twins.push_back({sides[i].low, -1, -1, sides[i].a, sides[i].b});
  return twins;
}

std::vector<InnerSide> sides_to_part(std::vector<InnerSide> all, std::span<const Region> regions,
                                     const EdgeNodes& nodes) {
  std::vector<InnerSide> found;
  if (all.empty()) return found;
  std::sort(all.begin(), all.end());
  const std::set<std::pair<int, int>> intervals = intervals_of(regions, nodes);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is_first = i == 0 || all[i - 1].low != all[i].low || all[i - 1].high != all[i].high;
    if (!is_first || intervals.contains({all[i].low, all[i].high})) found.push_back(all[i]);
  }
  return found;
}

std::vector<Vec3> divide_inner_sides(const Region& region, std::span<const InnerSide> sides, RegionMesh& mesh) {
  SideDivider divider(region, mesh);
  for (const InnerSide& side : sides) divider.divide(side.a, side.b);
  return divider.take_made();
}

}  // namespace paver
