// Curved elements that fold are straightened step by step.
#pragma once

#include <functional>
#include <vector>

#include "paver/result.h"

namespace paver {

/// Whether one element's Jacobian is proven positive. The stage that measures quality gives this function, so that
/// repair need not know how it is proven.
using IsValidFn = std::function<bool(const SurfaceMesh& mesh, bool is_quad, int element)>;

struct RepairResult {
  long straightened = 0;                              ///< elements mended
  double off_edge = 0;                                ///< mm, how far a middle was moved off its B-rep edge
  std::vector<int> moved;                             ///< nodes that mending moved, rising
  std::vector<int> invalid_quads, invalid_triangles;  ///< what no step could mend, in order
};

/// Mends elements of an order-2 mesh that are known as invalid. In this order, until valid: the centre as the blend of
/// the sides; the middles of its interior sides 1/2, 3/4 and all the way to the middle of the chord. Middles on B-rep
/// edges, nodes before `first_inside`, which parts share, and corners never move. A valid neighbour stays valid (it may
/// be straightened for that, too), else the element is left as it was and listed.
RepairResult repair_elements(SurfaceMesh& mesh, const IsValidFn& is_valid, const std::vector<int>& invalid_quads,
                             const std::vector<int>& invalid_triangles, int first_inside = 0);

/// The last resort for elements that the above left invalid: the same steps with the middles on B-rep edges moving,
/// too. All faces of an edge share its middle, so the mesh stays conforming; `off_edge` tells the price. Reaches ten
/// elements far.
RepairResult straighten_at_edges(SurfaceMesh& mesh, const IsValidFn& is_valid, const std::vector<int>& invalid_quads,
                                 const std::vector<int>& invalid_triangles);

}  // namespace paver
