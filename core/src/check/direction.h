// Whether elements run with the surface that they stand for.
#pragma once

#include <array>

#include "regions/region.h"

namespace paver {

/// Of any length.
struct ElementNormals {
  Vec3 area;     ///< all of the element
  Vec3 centre;   ///< at its centre
  Vec3 corners;  ///< of the surface at its corners, as xp x xq, the mean of unit vectors
};

/// `places`: of its corners in the chart. The corners' normals tell where they are near the element's own. Elsewhere
/// the surface's at its middle has to run with the element, and either the corners' mean or, where they lie on a lip
/// that is narrow against the element, those beside all corners.
bool runs_with_surface(const Region& region, int corners, const std::array<Vec2, 4>& places,
                       const ElementNormals& normals);

}  // namespace paver
