// Mesh edges by counting: sides of all elements are dealt into one bucket per lower node, and each small bucket is
// sorted by the upper node. Linear in the number of elements, no hashing.
#include <algorithm>

#include "quality/mesh_edges_impl.h"

namespace paver {
namespace {

/// Calls f(a, b) for every side of every element, from corner to corner.
template <class Function>
void for_each_side(const SurfaceMesh& mesh, Function f) {
  auto walk = [&](const std::vector<int>& elements, int corners, int stride) {
    for (std::size_t at = 0; at < elements.size(); at += stride) {
      for (int k = 0; k < corners; ++k) f(elements[at + k], elements[at + (k + 1) % corners]);
    }
  };
  walk(mesh.quads, 4, mesh.nodes_per_quad());
  walk(mesh.triangles, 3, mesh.nodes_per_triangle());
}

/// Buckets of upper nodes: those of node i are upper[start[i]] to upper[start[i + 1]].
struct Buckets {
  std::vector<std::size_t> start;
  std::vector<int> upper;
};

Buckets deal_sides(const SurfaceMesh& mesh) {
  Buckets buckets;
  buckets.start.assign(mesh.nodes.size() + 1, 0);
  for_each_side(mesh, [&](int a, int b) { ++buckets.start[std::min(a, b) + 1]; });
  for (std::size_t i = 1; i < buckets.start.size(); ++i) buckets.start[i] += buckets.start[i - 1];
  buckets.upper.resize(buckets.start.back());
  std::vector<std::size_t> next(buckets.start.begin(), buckets.start.end() - 1);
  for_each_side(mesh, [&](int a, int b) { buckets.upper[next[std::min(a, b)]++] = std::max(a, b); });
  return buckets;
}

}  // namespace

EdgeFigures measure_edges(const SurfaceMesh& mesh) {
  EdgeFigures figures;
  std::size_t n = mesh.nodes.size();
  figures.valence.assign(n, 0);
  figures.is_corner.assign(n, false);
  figures.is_border.assign(n, false);
  Buckets buckets = deal_sides(mesh);
  figures.chords.reserve(buckets.upper.size() / 2 + 1);
  for (std::size_t low = 0; low < n; ++low) {
    auto begin = buckets.upper.begin() + static_cast<long>(buckets.start[low]);
    auto end = buckets.upper.begin() + static_cast<long>(buckets.start[low + 1]);
    std::sort(begin, end);
    while (begin != end) {
      int high = *begin;
      auto next = std::find_if(begin, end, [high](int other) { return other != high; });
      long uses = next - begin;
      begin = next;
      figures.chords.push_back(norm(mesh.nodes[low] - mesh.nodes[high]));
      figures.border += uses == 1;
      figures.nonmanifold += uses > 2;
      for (std::size_t node : {low, static_cast<std::size_t>(high)}) {
        ++figures.valence[node];
        figures.is_corner[node] = true;
        if (uses == 1) figures.is_border[node] = true;
      }
    }
  }
  return figures;
}

}  // namespace paver
