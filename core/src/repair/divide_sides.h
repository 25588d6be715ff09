// Sides on B-rep edges get a node, on all faces of the edge.
#pragma once

#include <compare>

#include "boundary/edge_nodes.h"
#include "repair/edits/refill.h"

namespace paver {

/// By its two nodes of the boundary stage.
struct SideToDivide {
  int edge = -1, a = -1, b = -1;
  auto operator<=>(const SideToDivide&) const = default;
};

struct DividedSide {
  int a = -1, b = -1;
  int node = -1;  ///< of the boundary stage, new
};

/// Sides on B-rep edges of flat triangles whose third corner is a node of the boundary, too, nearer to the side than a
/// tenth of its length: there a node hangs in the side but for its name.
std::vector<SideToDivide> sides_beside_nodes(const ElementJudge& judge);

/// Divides the intervals in their middle by arc length. New nodes follow those that there are, in the order of `sides`;
/// each interval is divided once.
std::vector<DividedSide> divide_intervals(const Model& model, std::vector<SideToDivide> sides, EdgeNodes& nodes);

/// The elements at these sides of the judge's mesh, `mesh`, get the node, too: a triangle becomes two, a quad a
/// triangle and a quad, or three triangles where that is better.
void divide_boundary_sides(const ElementJudge& judge, const EdgeNodes& nodes, const std::vector<DividedSide>& sides,
                           ElementKinds kinds, RegionMesh& mesh);

}  // namespace paver
