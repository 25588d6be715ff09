// Rings of quads about a small hole.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// About a loop that is a round hole of a few facets, short against the target length: rings, each as much wider than
/// the last one as its columns ask for. `loops`: nodes in the mesh. Nodes of the outermost ring, else of the loop.
std::vector<int> lay_hole_rings(const Region& region, RegionMesh& mesh, const std::vector<std::vector<int>>& loops,
                                std::size_t hole);

}  // namespace paver
