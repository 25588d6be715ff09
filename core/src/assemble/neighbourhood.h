// Elements about some invalid ones, from all ranks: what mending across parts needs to see.
#pragma once

#include <vector>

#include "paver/mesher.h"

namespace paver {

/// A part of the whole mesh that every rank has, its tables in the order of the whole's.
struct Neighbourhood {
  SurfaceMesh mesh;  ///< nodes, quads and triangles with their faces, node_edge
  std::vector<int> invalid_quads, invalid_triangles;
  std::vector<long> node_number, quad_number, triangle_number;  ///< in the whole mesh
};

/// Collective. The elements at most `rings` elements away from those that are invalid on any rank, rows in `share`.
Neighbourhood gather_neighbourhood(const MeshShare& share, const std::vector<int>& invalid_quads,
                                   const std::vector<int>& invalid_triangles, int rings, Ranks& ranks);

/// Takes over where the nodes are now.
void put_nodes_back(const Neighbourhood& from, MeshShare& share);

/// Rows in the share of rows of the neighbourhood, those that are here.
std::vector<int> rows_here(const std::vector<int>& rows, const std::vector<long>& numbers,
                           const RowNumbers& numbers_here);

}  // namespace paver
