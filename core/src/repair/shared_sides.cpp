#include "repair/shared_sides.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "curving/near_surface.h"
#include "repair/curved_element.h"

namespace paver {
namespace {

/// Intervals of the edges that bound regions, by their nodes.
std::set<std::pair<int, int>> intervals_of(std::span<const Region> regions, const EdgeNodes& nodes) {
  std::set<std::pair<int, int>> intervals;
  for (int edge : bounding_edges(regions)) {
    const std::vector<int>& along = nodes.edges[edge].node;
    for (std::size_t i = 1; i < along.size(); ++i) intervals.insert(std::minmax(along[i - 1], along[i]));
  }
  return intervals;
}

using TwoElements = std::array<Corners, 2>;

/// The element with a node between its corners a and b: the better of two ways, if one has positive elements only.
std::optional<TwoElements> best_division(const RegionMesh& mesh, const Element& e, int a, int b, int middle) {
  std::optional<TwoElements> best;
  double most = 0;
  auto consider = [&](const Corners& one, const Corners& other) {
    const double worst = std::min({1.0, positive_jacobian(mesh, one), positive_jacobian(mesh, other)});
    if (worst > most) most = worst, best = TwoElements{one, other};
  };
  const int c = e.after(b), d = e.before(a);
  if (e.corners() == 3) {
    consider({a, middle, c, -1}, {middle, b, c, -1});
  } else {
    consider({a, middle, d, -1}, {middle, b, c, d});
    consider({middle, b, c, -1}, {a, middle, c, d});
  }
  return best;
}

/// Between a and b, at p. The new node, or -1.
int divide_at(const Region& region, int a, int b, Vec2 p, RegionMesh& mesh) {
  const int e = mesh.across(b, a), other = mesh.across(a, b);
  const int middle = mesh.add_node(region.place(p), 0.5 * (mesh.h[a] + mesh.h[b]));
  const auto here = best_division(mesh, mesh.elements[e], a, b, middle);
  const auto there = best_division(mesh, mesh.elements[other], b, a, middle);
  if (!here || !there) {
    mesh.drop_last_node();
    return -1;
  }
  mesh.remove_element(e);
  mesh.remove_element(other);
  for (const TwoElements& elements : {*here, *there})
    for (const Corners& corners : elements) mesh.add_element(corners);
  return middle;
}

/// The new node, or -1.
int divide_side(const Region& region, int a, int b, RegionMesh& mesh) {
  if (mesh.across(a, b) < 0 || mesh.across(b, a) < 0) return -1;
  Vec2 p = 0.5 * (mesh.p[a] + mesh.p[b]);
  if (const int node = divide_at(region, a, b, p, mesh); node >= 0) return node;
  // In a polar chart that lies beside the side, by more than a thin element is wide.
  nearest_point(region, p, 0.5 * (mesh.x[a] + mesh.x[b]), norm(mesh.x[b] - mesh.x[a]));
  return divide_at(region, a, b, p, mesh);
}

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
  std::vector<Vec3> made;
  for (const InnerSide& side : sides)
    if (const int node = divide_side(region, side.a, side.b, mesh); node >= 0) made.push_back(mesh.x[node]);
  return made;
}

}  // namespace paver
