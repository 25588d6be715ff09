// Numbering of nodes and elements along a curve that fills the chart.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"

namespace paver {

/// Numbers nodes and elements so that what lies near each other in the chart does so in memory; elements that were
/// removed leave no gap. Returns the new number of each node.
std::vector<int> order_spatially(RegionMesh& mesh);

}  // namespace paver
