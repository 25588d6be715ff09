#include "repair/edits/row_along.h"

namespace paver {

bool is_straight(const ElementJudge& judge, int before, int v, int after, double most_sine) {
  const RegionMesh& mesh = judge.mesh();
  const BoundarySide *in = judge.sides().find(mesh.global[before], mesh.global[v]),
                     *out = judge.sides().find(mesh.global[v], mesh.global[after]);
  if (!in || !out) return false;
  const Vec3 x = mesh.x[v], back = unit(4 * in->middle - 3 * x - mesh.x[before]),
             on = unit(4 * out->middle - 3 * x - mesh.x[after]);
  return dot(back, on) < 0 && norm(cross(back, on)) <= most_sine;
}

bool has_straight_corner(const ElementJudge& judge, int element) {
  const Element& e = judge.mesh().elements[element];
  const int n = e.corners();
  for (int k = 0; k < n; ++k)
    if (is_straight(judge, e.v[(k + n - 1) % n], e.v[k], e.v[(k + 1) % n])) return true;
  return false;
}

std::vector<SmoothChain> smooth_chains(const ElementJudge& judge, std::span<const int> outline) {
  const std::size_t n = outline.size();
  std::vector<char> is_flat(n);
  std::size_t start = n;  // a node where the border does not go on straight
  for (std::size_t i = 0; i < n; ++i) {
    is_flat[i] = is_straight(judge, outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]);
    if (!is_flat[i] && start == n) start = i;
  }
  std::vector<SmoothChain> chains;
  if (start == n) return chains;
  for (std::size_t k = 1; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (!is_flat[i]) continue;
    if (k > 1 && is_flat[(i + n - 1) % n]) {
      ++chains.back().sides;
    } else {
      chains.push_back({(i + n - 1) % n, 2});
    }
  }
  return chains;
}

bool leaves_filling(std::span<const int> outline, SmoothChain chain) {
  return outline.size() > chain.sides + 2 || (outline.size() == chain.sides + 2 && chain.sides > 2);
}

BorderRow row_along(std::span<const int> outline, SmoothChain chain, std::span<const int> made) {
  const std::size_t n = outline.size();
  auto at = [&](std::size_t i) { return outline[(chain.first + i) % n]; };
  BorderRow row;
  std::vector<int> inner{at(n - 1)};  // beside the chain's nodes
  inner.insert(inner.end(), made.begin(), made.end());
  inner.push_back(at(chain.sides + 1));
  for (std::size_t k = 0; k < chain.sides; ++k) row.quads.push_back({at(k), at(k + 1), inner[k + 1], inner[k]});
  if (inner.front() == inner.back()) inner.pop_back();
  row.rest = std::move(inner);
  for (std::size_t k = chain.sides + 2; k + 1 < n; ++k) row.rest.push_back(at(k));
  return row;
}

std::vector<Vec2> places_of_row(const RegionMesh& mesh, std::span<const int> outline, SmoothChain chain) {
  Vec2 middle;
  for (int v : outline) middle = middle + (1.0 / static_cast<double>(outline.size())) * mesh.p[v];
  std::vector<Vec2> places;
  for (std::size_t k = 1; k < chain.sides; ++k)
    places.push_back(0.5 * (mesh.p[outline[(chain.first + k) % outline.size()]] + middle));
  return places;
}

}  // namespace paver
