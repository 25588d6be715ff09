// Opposite sides of four-sided and ring-shaped faces given the same interval count.
#pragma once

#include <vector>

#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Ties edges that lie opposite each other on a face of four sides with corners between 45 and 135 degrees, or that
/// are the two ends of a tube (two loops of one edge each on a face with a periodic edge), as long as all counts of
/// a tied group lie within one of each other. Each group takes its rounded mean wish, at least its largest minimum.
/// `loops[f]`: linked_loops of face f without periodic edges.
void tie_opposite_sides(const Model& model, const std::vector<std::vector<Loop>>& loops,
                        std::vector<EdgeCount>& counts);

}  // namespace paver
