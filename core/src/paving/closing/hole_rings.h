// Rings of quads about a small hole.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// About those of `holes` that are round loops of a few facets, short against the target length: rings, each as much
/// wider than the last one as its columns ask for. `loops`: nodes in the mesh; those with rings become the outermost
/// one.
void lay_hole_rings(const Region& region, RegionMesh& mesh, std::vector<std::vector<int>>& loops,
                    const std::vector<std::size_t>& holes);

}  // namespace paver
