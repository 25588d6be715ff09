// What a chart that bends straight lines hides: between a chord of the boundary and its curve there is no surface.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// Whether all elements about the node face the surface, and it is on the surface's side of fixed facets about it.
bool faces_surface(const Front& front, int node);

/// Whether a place in void triangle t is beyond a fixed facet of it on the surface, if not in the chart.
bool is_beyond_facet(const Front& front, int t, const NodePlace& at);

}  // namespace paver
