// Closure: filling a loop of few nodes.
#pragma once

#include <vector>

#include "paving/front/front.h"

namespace paver {

/// Fills a loop of 3 to 8 facets with the pattern of best worst quality: 3 a triangle, 4 a quad, 6 and 8 quads across
/// diagonals or about one new node. Loops of 6 and 8 are left alone (false) when no pattern is good enough.
bool close_loop(Front& front, const std::vector<int>& loop);

/// Fills the void that facet f borders with its own triangles, merged in pairs where that makes a fair quad.
/// The last resort: always works.
void close_by_triangulation(Front& front, int f);

/// Takes a loop with an odd number of facets to an even one by a triangle at its sharpest corner, or on a facet where
/// no corner is sharp. A loop of three is filled.
void insert_triangle(Front& front, const std::vector<int>& loop);

}  // namespace paver
