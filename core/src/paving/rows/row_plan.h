// States and wishes of all nodes of a row, made before its first quad from the undisturbed front.
#pragma once

#include <vector>

#include "paving/rows/row.h"

namespace paver {

/// Plan for the end node of one facet of a row: from the side nearest to that facet on, up to five wishes
/// (side node, then diagonal and side in turn).
struct NodePlan {
  NodeState state = NodeState::side;
  double angle = 0;  ///< between the chords, radians: places nodes; the state is by the true angle
  int count = 0;
  Wish wish[5];
};

/// plans[i] belongs to the end node of row.facets[i]. Where the row widens or narrows beyond measure a side becomes a
/// corner (wedge) or an end (tuck) so that the length comes back to the target.
std::vector<NodePlan> plan_row(const Front& front, const Row& row);

}  // namespace paver
