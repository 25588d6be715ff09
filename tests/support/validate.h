// Checks of the paving structures that the core itself never makes: everything is looked at, nothing is assumed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/region_mesh.h"
#include "paving/front/front.h"
#include "paving/front/void_triangulation.h"
#include "regions/region.h"

namespace paver::test {

/// Each of these gives sentences, one per line; empty when all is well.

/// Triangles counter-clockwise, neighbours mutual, each live facet on its triangle, areas adding up to `area`
/// (relative 1e-12). `facets` by number: start and end; (-1, -1): no longer there.
std::string void_faults(const VoidTriangulation& empty, const std::vector<Vec2>& points,
                        const std::vector<std::pair<int, int>>& facets, double area);

/// Sides inside the void whose far corner lies in the circle of the triangle on the other side.
std::string delaunay_faults(const VoidTriangulation& empty, const std::vector<Vec2>& points);

/// void_faults of the front's void and facets; facets linked in closed loops; elements and void together have the
/// region's area.
std::string front_faults(const Front& front);

/// Every element has distinct corners and turns left at each of them in the chart; areas add up to the region's
/// (relative 1e-12); boundary edges are exactly the region's facets; every other edge lies in two elements with
/// opposite direction; boundary nodes are where they were.
std::string paved_faults(const Region& region, const RegionMesh& mesh);

}  // namespace paver::test
