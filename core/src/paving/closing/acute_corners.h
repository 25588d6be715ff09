// Acute corners of loops, filled before paving.
#pragma once

#include <vector>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Lays two columns of quads into each corner of an even loop from `sharpest` to 45 degrees (radians here), out to
/// where they are about as wide as the target length, and takes it off the loop: `nodes`, region on the left, becomes
/// shorter by an even number. Left to rows, such corners end in triangles, with long quads across. `others` are the
/// nodes of all loops: none of them may lie there.
void lay_acute_corners(const Region& region, RegionMesh& mesh, const std::vector<LoopNode>& loop,
                       std::vector<int>& nodes, const std::vector<Vec2>& others, double sharpest);

}  // namespace paver
