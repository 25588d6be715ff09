// Edges of a paved coarse region and its chords.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "mesh/region_mesh.h"
#include "multilevel/coarse/coarse_region.h"

namespace paver {

struct CoarseEdge {
  int a = -1, b = -1;
  std::array<int, 2> element{-1, -1};
  int loop = -1, facet = -1;  ///< of the region, where it runs from a to b on its boundary
};

struct CoarseNet {
  std::vector<CoarseEdge> edges;
  std::vector<std::array<int, 4>> of_element;  ///< per element: its edge from corner i to the next, -1 where none
  std::vector<std::vector<int>> loop_node;     ///< per loop and coarse node: node of the mesh
};

/// Edges that follow each other across quads: what divides one divides all. It ends on a side of the region, at a
/// triangle (side -1), or in itself.
struct Chord {
  std::vector<int> edges;
  std::array<int, 2> side{-1, -1};
};

/// Nothing where an edge inside lies in one element only or one on the boundary in two.
std::optional<CoarseNet> build_net(const CoarseRegion& coarse, const RegionMesh& mesh);

/// Every edge is in exactly one chord.
std::vector<Chord> find_chords(const CoarseRegion& coarse, const RegionMesh& mesh, const CoarseNet& net);

/// A coarse edge on the outline of a part of the mesh, run through so that the part is on its left.
struct OutlineEdge {
  int edge = -1, from = -1, to = -1;
};

/// Edges between an element of `part` (rising) and one outside, or the boundary; by start node.
std::multimap<int, OutlineEdge> outline_of(const std::vector<int>& part, const RegionMesh& mesh, const CoarseNet& net);

}  // namespace paver
