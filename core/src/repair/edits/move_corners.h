// Free nodes go where the elements about them are better.
#pragma once

#include "repair/curved_element.h"

namespace paver {

/// Of a bad element, where the worst about each is best. All back, and false, where that does not make every element
/// about the nodes worth `least`.
bool move_corners(const ElementJudge& judge, int element, double least, RegionMesh& mesh);

/// Nodes go, one after the other, where the worst element about each is best.
void raise_worst_about(const ElementJudge& judge, const std::vector<int>& nodes, RegionMesh& mesh);

/// Nodes go towards elements of the target length, as long as those about them are good or no worse than before.
void even_out(const ElementJudge& judge, const std::vector<int>& nodes, RegionMesh& mesh);

}  // namespace paver
