// Areas under sides as vectors: round an element they add up to its area times its mean normal.
#pragma once

#include "paver/vec.h"

namespace paver {

/// Twice the area between the origin and the straight side from a to b.
inline Vec3 swept(Vec3 a, Vec3 b) { return cross(a, b); }

/// The same for the parabola that is at m half way.
inline Vec3 swept(Vec3 a, Vec3 m, Vec3 b) { return (4.0 / 3) * (cross(a, m) + cross(m, b)) + (-1.0 / 3) * cross(a, b); }

/// Twice the area of an element of three or four corners as a vector. `x(k)`: its nodes in Gmsh's order; those behind
/// the corners are asked for where it is curved.
template <class Node>
Vec3 twice_area(int corners, bool is_curved, Node x) {
  Vec3 sum;
  for (int k = 0; k < corners; ++k) {
    const Vec3 a = x(k) - x(0), b = x(k + 1 < corners ? k + 1 : 0) - x(0);
    sum += is_curved ? swept(a, x(corners + k) - x(0), b) : swept(a, b);
  }
  return sum;
}

/// Normal of a curved element at its centre, of any length.
template <class Node>
Vec3 centre_normal(int corners, Node x) {
  if (corners == 4) return cross(x(5) - x(7), x(6) - x(4));
  return cross(x(1) - x(0) + 4 * (x(4) - x(5)), x(2) - x(0) + 4 * (x(4) - x(3)));
}

}  // namespace paver
