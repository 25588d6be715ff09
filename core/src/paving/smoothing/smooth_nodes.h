// Moving nodes: towards square elements of the target length, never at the cost of the worst one.
#pragma once

#include <vector>

#include "paving/front/front.h"

namespace paver {

/// Moves the given nodes in turn, twice. A node moves only if every element and void triangle about it stays
/// positive in the chart and the worst scaled Jacobian about it does not fall, or stays above 0.7.
/// Fixed nodes stay.
void smooth_nodes(Front& front, const std::vector<int>& nodes);

}  // namespace paver
