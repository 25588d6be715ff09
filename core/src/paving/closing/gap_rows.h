// Rows of quads along narrow gaps between sides whose nodes face each other.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Where nodes of the loops face each other across far less than their facets: quads from each to the next, as between
/// coupled lines. Left to rows, these may join each node with the one beside that which it faces. `loops`: nodes in the
/// mesh, the region on the left; those of what is left are returned. `may_be_odd`: they may take triangles.
std::vector<std::vector<int>> lay_gap_rows(const Region& region, RegionMesh& mesh, std::vector<std::vector<int>> loops,
                                           bool may_be_odd);

}  // namespace paver
