// Facets of a region's loops that cross or touch in its chart.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "regions/region.h"

namespace paver {

/// Nodes of a region's loops as paving sees them: where loops touch in one of the boundary stage's nodes that is one
/// node; the two sides of a cut do not.
struct LoopNodes {
  std::vector<std::vector<int>> of_loop;  ///< per loop and place in it: its node
  std::vector<Vec2> at;                   ///< per node
};
LoopNodes number_loop_nodes(const Region& region);

/// Length in the chart of the shorter one of the two facets at a node: what is near there. A slit's may be far longer.
double shorter_facet(const std::vector<LoopNode>& loop, std::size_t place);

/// The facet that starts at place `place` of loop `loop`; loops from Region::loops.size() on are the rings of fans.
struct LoopFacet {
  int loop = -1, place = -1;
  auto operator<=>(const LoopFacet&) const = default;
};

/// Pairs that have more in common than a node that they share, by their order in the loops, and at most `most` of them;
/// then a facet with the first one of a fan, where it cuts the fan's centre off from the region.
/// Two facets on one edge that run against each other between the same nodes are a slit and are no such pair.
std::vector<std::array<LoopFacet, 2>> crossing_facets(const Region& region, std::size_t most);

}  // namespace paver
