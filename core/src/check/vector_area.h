// Areas under sides as vectors: round an element they add up to its area times its mean normal.
#pragma once

#include "paver/vec.h"

namespace paver {

/// Twice the area between the origin and the straight side from a to b.
inline Vec3 swept(Vec3 a, Vec3 b) { return cross(a, b); }

/// The same for the parabola that is at m half way.
inline Vec3 swept(Vec3 a, Vec3 m, Vec3 b) { return (4.0 / 3) * (cross(a, m) + cross(m, b)) + (-1.0 / 3) * cross(a, b); }

}  // namespace paver
