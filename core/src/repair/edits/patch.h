// A few elements of a region's mesh and the loop about them.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"

namespace paver {

using ElementSet = std::vector<int>;

/// Elements across the sides of one, each once.
ElementSet neighbours_of(const RegionMesh& mesh, int element);

/// All elements at its nodes, itself as well, rising.
ElementSet ring_about(const RegionMesh& mesh, int element);

/// Of an element, but for fixed ones.
std::vector<int> free_corners(const RegionMesh& mesh, int element);

/// Nodes up to two elements away from some, rising, but for fixed ones.
std::vector<int> free_nodes_near(const RegionMesh& mesh, const std::vector<int>& nodes);

struct PatchOutline {
  std::vector<int> loop;    ///< counter-clockwise; empty where there is not one simple loop
  std::vector<int> inside;  ///< nodes that are not on it
};
PatchOutline outline_of(const RegionMesh& mesh, const ElementSet& set, std::size_t most_nodes);

/// Whether elements outside the set have a side between two nodes.
bool is_side_outside(const RegionMesh& mesh, const ElementSet& set, int a, int b);

/// The element's corners, with a node between two of them wherever `between` gives one (else -1).
template <class Between>
std::vector<int> with_nodes_between(const Element& element, Between between) {
  std::vector<int> outline;
  for (int k = 0, n = element.corners(); k < n; ++k) {
    const int a = element.v[k], b = element.v[(k + 1) % n], node = between(a, b);
    outline.push_back(a);
    if (node >= 0) outline.push_back(node);
  }
  return outline;
}

/// The same with one node, between a and b.
inline std::vector<int> with_node_between(const Element& element, int a, int b, int node) {
  return with_nodes_between(element,
                            [&](int v, int w) { return (v == a && w == b) || (v == b && w == a) ? node : -1; });
}

}  // namespace paver
