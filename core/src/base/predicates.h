// Exact orientation test: every decision about overlap and inversion rests on it.
#pragma once

#include <span>

#include "paver/vec.h"

namespace paver {

namespace detail {
double exact_orientation(Vec2 a, Vec2 b, Vec2 c);
}

/// Positive when a, b, c turn left, negative when right, zero exactly when they are in line.
/// The sign is exact for all finite input without over- or underflow [Shewchuk97].
inline double orientation(Vec2 a, Vec2 b, Vec2 c) {
  double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  double det = left - right;
  double bound = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
  if (det > bound || -det > bound) return det;
  return detail::exact_orientation(a, b, c);
}

/// 1 where c lies to the left of the line from a to b, -1 to the right, 0 on it.
inline int side_of_line(Vec2 a, Vec2 b, Vec2 c) {
  const double area = orientation(a, b, c);
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

/// Whether p lies inside a polygon and is none of its corners.
inline bool is_inside(std::span<const Vec2> polygon, Vec2 p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 from = polygon[i], to = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if (from == p) return false;
    if ((from.y > p.y) != (to.y > p.y) && (orientation(from, to, p) > 0) == (to.y > from.y)) inside = !inside;
  }
  return inside;
}

/// Whether d lies inside the circle through a, b, c (counter-clockwise) by more than rounding.
/// Not exact: a doubtful case is a "no", which only costs shape of a supporting triangle, never validity.
inline bool in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  Vec2 u = a - d, v = b - d, w = c - d;
  double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  double vw1 = v.x * w.y, vw2 = w.x * v.y, wu1 = w.x * u.y, wu2 = u.x * w.y, uv1 = u.x * v.y, uv2 = v.x * u.y;
  double det = uu * (vw1 - vw2) + vv * (wu1 - wu2) + ww * (uv1 - uv2);
  double size = uu * (std::fabs(vw1) + std::fabs(vw2)) + vv * (std::fabs(wu1) + std::fabs(wu2)) +
                ww * (std::fabs(uv1) + std::fabs(uv2));
  return det > 1e-14 * size;
}

}  // namespace paver
