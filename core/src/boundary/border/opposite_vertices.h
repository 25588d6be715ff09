// Nodes of long straight intervals opposite the vertices that lie close before them.
#pragma once

#include <vector>

#include "boundary/border/border_facets.h"
#include "topology/model.h"

namespace paver {

/// Straight edges of few intervals get a node opposite each vertex of the same face that is nearer than a tenth of an
/// interval, with nothing between: the base of a comb opposite its teeth. Not where the vertex lies opposite a corner
/// of the face already, as on a frame. Gives per edge of the model shares of its length, nearest vertices first.
/// `loops[f]`: linked_loops of face f without periodic edges.
OppositeShares face_near_vertices(const Model& model, const std::vector<std::vector<Loop>>& loops,
                                  std::vector<EdgeCount>& counts);

}  // namespace paver
