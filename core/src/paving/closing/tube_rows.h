// Rows of quads round a slim tube.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Elements round a tube where no rim tells: as many as its turn asks for, an even number.
std::size_t columns_by_turn(const Region& region);

/// Where a tube is cut open along its periodic edge, and narrow against the target length: rows from one side of the
/// cut to the other, as far as nothing else is there. `loops`: nodes in the mesh; those of what is left are returned.
std::vector<std::vector<int>> lay_tube_rows(const Region& region, RegionMesh& mesh,
                                            std::vector<std::vector<int>> loops);

}  // namespace paver
