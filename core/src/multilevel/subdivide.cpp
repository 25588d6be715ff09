// Which coarse elements are divided and which are paved.
#include "multilevel/subdivide.h"

#include <algorithm>

#include "multilevel/patches.h"

namespace paver {
namespace {

// Mean length of the fine edges along a coarse one, by their target length.
constexpr double shortest = 0.72, longest = 1.4;
constexpr double bent = 0.7071;     // cosine between the normals at the ends of a coarse edge, 45 degrees
constexpr int rings = 2;            // of coarse elements about the marked ones
constexpr double most_paved = 0.5;  // of the area

bool is_far_off(int e, const CoarseNet& net, const std::vector<int>& counts, const std::vector<double>& lengths) {
  if (net.edges[e].loop >= 0) return false;
  double length = lengths[e] / counts[e];
  return length < shortest || length > longest;
}

std::vector<char> marks(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                        const std::vector<double>& lengths) {
  std::vector<char> is_marked(mesh.elements.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const Element& element = mesh.elements[e];
    if (!element.is_alive()) continue;
    const auto& around = net.of_element[e];
    for (int k = 0, n = element.corners(); k < n; ++k) {
      bool is_unequal = n == 4 && k < 2 && counts[around[k]] != counts[around[k + 2]];
      is_marked[e] |= is_unequal || is_far_off(around[k], net, counts, lengths);
    }
  }
  return is_marked;
}

// Elements beside a bent edge cannot follow the surface, and what is divided from them lies on it askew.
void mark_bent(const RegionMesh& mesh, const CoarseNet& net, std::vector<char>& is_marked) {
  for (const CoarseEdge& edge : net.edges)
    if (dot(unit(mesh.normal(edge.a)), unit(mesh.normal(edge.b))) < bent)
      for (int e : edge.element)
        if (e >= 0) is_marked[e] = 1;
}

// Paving needs some room.
void grow(const RegionMesh& mesh, std::vector<char>& is_marked) {
  const std::vector<char> before = is_marked;
  for (std::size_t e = 0; e < before.size(); ++e) {
    if (!before[e]) continue;
    for (int v : mesh.elements[e].v) {
      if (v < 0) continue;
      for (int other : mesh.star[v]) is_marked[other] = 1;
    }
  }
}

bool is_too_much(const std::vector<char>& is_marked, const RegionMesh& mesh) {
  long marked = std::count_if(is_marked.begin(), is_marked.end(), [](char mark) { return mark != 0; });
  return static_cast<double>(marked) > most_paved * static_cast<double>(mesh.living_elements());
}

}  // namespace

std::vector<char> choose_paved(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                               const std::vector<double>& lengths) {
  std::vector<char> is_marked = marks(mesh, net, counts, lengths);
  for (int ring = 0; ring < rings; ++ring) {
    if (ring == 1) mark_bent(mesh, net, is_marked);  // one ring is room enough about these
    grow(mesh, is_marked);
  }
  settle_marks(mesh, net, is_marked);
  if (is_too_much(is_marked, mesh)) is_marked.clear();
  return is_marked;
}

}  // namespace paver
