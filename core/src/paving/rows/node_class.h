// State of a front node: how many nodes it adds to the row that passes it.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// Interior angle about pi/2, pi, 3 pi/2, 2 pi; adds 0, 1, 3, 5 nodes.
enum class NodeState { end, side, corner, reversal };

/// State by angle and by the edges that already meet at the node, so that its final valence comes out regular.
/// Limits from [Blacker91] and [White97].
NodeState classify(const Front& front, int node, double angle);

/// How far the angle is from the ideal of the state, radians, weighted for the valence that results [White97].
double ambiguity(const Front& front, int node, double angle, NodeState state);

}  // namespace paver
