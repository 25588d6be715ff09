// Nearest point of a surface from a good guess: how new nodes get onto their face.
#pragma once

#include "brep/surface.h"

namespace paver {

/// Moves `uv` (a guess in, the result out) to where the surface is nearest to `target`, and gives the point there in
/// `x`. Damped Newton, at most 10 iterations, never farther from the target than the guess was; done when a step is
/// below 1e-12 of the guess's distance. False, with uv and x as good as reached but always finite, when it does not
/// converge: at a pole, for a guess on the wrong side, or for coordinates that are not finite.
bool closest_on_surface(const Surface& surface, Vec2& uv, Vec3 target, Vec3& x);

}  // namespace paver
