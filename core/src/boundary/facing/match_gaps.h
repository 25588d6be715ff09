// Nodes that face each other across narrow gaps.
#pragma once

#include <vector>

#include "boundary/parity.h"
#include "sizing/size_field.h"
#include "topology/model.h"

namespace paver {

/// Where a face is smaller than the target length, and a gap between two loops that is narrower than 0.7 of its size,
/// the loop of fewer intervals gets as many as the other one, and both some more so that the edges of the former get
/// equally many; but only where one row of quads across the gap would be good with these. `loops[f]`: linked_loops of
/// face f without periodic edges.
void match_gaps(const Model& model, const SizeField& size, const std::vector<std::vector<Loop>>& loops,
                std::vector<EdgeCount>& counts);

}  // namespace paver
