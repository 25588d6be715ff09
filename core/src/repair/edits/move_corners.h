// Free nodes of a bad element go where the worst element about them is best.
#pragma once

#include "repair/curved_element.h"

namespace paver {

/// All back, and false, where that does not make every element about the nodes worth `least`.
bool move_corners(const ElementJudge& judge, int element, double least, RegionMesh& mesh);

/// Nodes from `first` on, one after the other, as far as that makes the worst element about each better.
void settle_nodes(const ElementJudge& judge, int first, RegionMesh& mesh);

}  // namespace paver
