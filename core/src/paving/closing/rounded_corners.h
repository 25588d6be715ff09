// Rounded corners of loops, filled before paving.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Where a corner of a loop is rounded by two facets far shorter than those beside it, fills the corner up to the next
/// nodes of its sides, with three quads, one of them as two triangles where the border is smooth in the corner's
/// middle, and takes it off the loop: `loop` and its `nodes`, region on the left, become shorter by two, and sharp
/// there. Left to rows, which see no corner, these tangle there. `others` are the places of the nodes of all loops:
/// none of them may lie there.
void lay_rounded_corners(const Region& region, RegionMesh& mesh, std::vector<LoopNode>& loop, std::vector<int>& nodes,
                         const std::vector<Vec2>& others);

}  // namespace paver
