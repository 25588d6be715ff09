// Faces of two and three sides that quads cannot fill.
#pragma once

#include <vector>

#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Gives two intervals to the edges of faces with two or three sides, of which all but one have one interval each: a
/// quad there would have two sides on the other one, and no angle between them. Not where one of these edges is short
/// against the target length. `loops[f]`: linked_loops of face f without periodic edges.
void divide_few_sides(const Model& model, const std::vector<std::vector<Loop>>& loops, std::vector<EdgeCount>& counts);

}  // namespace paver
