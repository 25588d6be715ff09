// Regions from faces: charts, loops of boundary nodes, artificial cuts and fans at apexes.
#pragma once

#include <vector>

#include "boundary/edge_nodes.h"
#include "regions/face_layout.h"
#include "regions/region.h"

namespace paver {

/// Regions of all faces that can be meshed, in face order. Nodes on artificial cuts and apexes inside faces are
/// appended to `nodes` (node_edge -1).
std::vector<Region> build_regions(const Model& model, const SizeField& size, const std::vector<FaceLayout>& layouts,
                                  EdgeNodes& nodes);

}  // namespace paver
