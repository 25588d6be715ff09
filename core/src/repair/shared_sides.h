// Sides inside a face that others have, too, between the same two nodes of their boundaries.
#pragma once

#include <span>
#include <vector>

#include "boundary/edge_nodes.h"
#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

struct InnerSide {
  int low = -1, high = -1;  ///< nodes of the boundary stage, low < high
  int part = -1;
  int a = -1, b = -1;  ///< its nodes in the part's mesh, `low` first
  auto operator<=>(const InnerSide&) const = default;
};

/// Those of a part's mesh that lie between two of its elements and two nodes of the boundary stage.
std::vector<InnerSide> inner_sides(const RegionMesh& mesh, int part, int boundary_nodes);

/// Those that have to go, so that no side is in more elements than may be: all where an interval of an edge of some
/// region runs between the same nodes, else all but the first. `all`: of all parts, in any order.
std::vector<InnerSide> sides_to_part(std::vector<InnerSide> all, std::span<const Region> regions,
                                     const EdgeNodes& nodes);

/// Sides of a part's mesh from one node inside to several that are the same node of the boundary stage, on both uses of
/// an edge: all but the first, which would be one mesh edge with it. `low` is that node; `high` and `part` are -1.
std::vector<InnerSide> twin_sides(const RegionMesh& mesh);

/// Gives sides inside a node in their middle; the two elements at one are
/// divided, so there are triangles. Stays where an element made would not be positive. Gives the new nodes' places.
std::vector<Vec3> divide_inner_sides(const Region& region, std::span<const InnerSide> sides, RegionMesh& mesh);

}  // namespace paver
