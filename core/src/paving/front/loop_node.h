// Nodes on the loops of a region, with a tangent plane that elements beside them can be judged by.
#pragma once

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// The new node's number. Where the surface has no tangent plane it gets that a little further `towards` a place in the
/// chart.
int add_loop_node(const Region& region, const LoopNode& known, Vec2 towards, bool is_fixed, RegionMesh& mesh);

/// Along a border where both derivatives run nearly the same way, or past each other, the surface has a tangent plane a
/// little further inside only: the node gets the first clear one, up to half an interval in. `along`: from the node
/// before to the next, the region on the left.
void take_clear_tangents(const Region& region, int node, Vec2 along, RegionMesh& mesh);

}  // namespace paver
