// Rings of quads about an apex.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Goes on from a fan's ring, whose nodes are given as numbers in the mesh, away from its centre. Nodes of the
/// outermost ring.
std::vector<int> lay_fan_rings(const Region& region, RegionMesh& mesh, const Fan& fan, std::vector<int> ring);

}  // namespace paver
