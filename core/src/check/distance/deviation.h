// How far an element's inside is from the surface that it stands for.
#pragma once

#include "check/distance/element_patch.h"
#include "regions/region.h"

namespace paver {

/// Largest distance from the surface, mm, of points at a quarter from its sides. `places`: of its corners in the
/// chart. Where the distance is not above `known`, any bound that is not either.
double deviation(const Region& region, const ElementPatch& element, const std::array<Vec2, 4>& places, double known);

}  // namespace paver
