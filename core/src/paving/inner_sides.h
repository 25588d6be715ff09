// Sides inside a region that other faces have too, between the same two nodes of their boundaries.
#pragma once

#include <utility>
#include <vector>

#include "regions/region.h"

namespace paver {

/// Gives sides between two nodes of the mesh a node in their middle; the two elements at one are divided, so there are
/// triangles. Sides that are not between two elements stay, and those where an element made would not be positive.
void divide_inner_sides(const Region& region, const std::vector<std::pair<int, int>>& sides, RegionMesh& mesh);

}  // namespace paver
