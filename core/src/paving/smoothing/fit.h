// The square or equilateral triangle nearest to an element: what smoothing fits elements to.
#pragma once

#include "mesh/region_mesh.h"

namespace paver {

/// Steps from the element's corners to those of the square (equilateral triangle) nearest to it, with sides between the
/// target length (`own_share` 0) and the length the element has now (1). False for a degenerate element.
bool fit(const RegionMesh& mesh, const Element& e, double own_share, MetricVec step[4]);

/// The same with sides of the target length, each of which also pulls its ends there where it is not far from it. Not
/// for the front: more triangles came of it.
bool fit_evenly(const RegionMesh& mesh, const Element& e, MetricVec step[4]);

}  // namespace paver
