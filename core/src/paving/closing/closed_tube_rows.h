// Rows of quads round a slim tube that no cut opens.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Where a region goes round and is narrow against the target length, as a mast that a boom is fastened to: rows round
/// it from its rims, and between what else is there, as far as that is away; they get shorter towards it. `loops`:
/// nodes in the mesh; those of what is left are returned.
std::vector<std::vector<int>> lay_closed_tube_rows(const Region& region, RegionMesh& mesh,
                                                   std::vector<std::vector<int>> loops);

}  // namespace paver
