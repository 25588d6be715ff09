// Rows of quads along smooth parts of a region's border.
#pragma once

#include <span>
#include <vector>

#include "repair/curved_element.h"

namespace paver {

/// Nodes i to i + sides of an outline, on the border of the region, which goes on straight at all but the first and the
/// last.
struct SmoothChain {
  std::size_t first = 0, sides = 0;
};

/// The chains of two sides and more; none where the border goes on straight at all nodes of the outline.
std::vector<SmoothChain> smooth_chains(const ElementJudge& judge, std::span<const int> outline);

/// A row along a chain, with a new node beside each node inside the chain.
struct BorderRow {
  std::vector<Corners> quads;
  std::vector<int> rest;  ///< the outline that is left
};

/// Whether what is left of an outline beside a row is a polygon.
bool leaves_filling(std::span<const int> outline, SmoothChain chain);

/// `made`: the new nodes, one fewer than the chain has sides.
BorderRow row_along(std::span<const int> outline, SmoothChain chain, std::span<const int> made);

/// Where these nodes may be at first: half way to the middle of the outline, in the chart.
std::vector<Vec2> places_of_row(const RegionMesh& mesh, std::span<const int> outline, SmoothChain chain);

/// Whether the border goes on straight at node v, so that no order 2 element has a Jacobian there: at a corner between
/// sides from `before` and to `after`, both on B-rep edges, of which the sine of the angle is at most `most_sine`.
bool is_straight(const ElementJudge& judge, int before, int v, int after, double most_sine = 0.2);

/// Whether an element has such a corner.
bool has_straight_corner(const ElementJudge& judge, int element);

}  // namespace paver
