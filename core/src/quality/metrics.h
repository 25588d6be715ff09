// Shape of one straight-sided element. Definitions: core/docs/quality.md, "Shape".
#pragma once

#include <numbers>

#include "paver/vec.h"

namespace paver {

constexpr double triangle_scale = 2 * std::numbers::inv_sqrt3;  ///< makes the equilateral triangle 1
constexpr double far_too_long = 4;                              ///< sides, by the target length

/// Scaled Jacobian of the straight-sided quad a b c d: least over its corners of (next side x previous side) . n over
/// the lengths of both sides, n the quad's own unit vector area. 1: square; 0: a flat corner or a side without length;
/// negative: concave or crossed. Does not depend on units.
double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// The same for the triangle a b c, times triangle_scale: 1 for an equilateral one, never negative.
double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c);

}  // namespace paver
