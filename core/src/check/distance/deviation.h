// How far an element's inside is from the surface that it stands for.
#pragma once

#include "check/distance/element_patch.h"
#include "regions/region.h"

namespace paver {

/// Linear or bilinear between an element's corners in the chart, whose places are `p`.
Vec2 place_at(const Region& region, int corners, const std::array<Vec2, 4>& p, Vec2 uv);

/// Largest distance from the surface, mm, of points inside, some of them near its sides. `places`: of its corners in
/// the chart. Where the distance is not above `known`, any bound that is not either.
double deviation(const Region& region, const ElementPatch& element, const std::array<Vec2, 4>& places, double known);

}  // namespace paver
