// Points beside straight segments, and within closed lines of them.
#pragma once

#include <algorithm>
#include <cmath>

#include "paver/vec.h"

namespace paver {

/// Where between a, at 0, and b, at 1, the segment is nearest to p.
template <class V>
double nearest_share(V p, V a, V b) {
  const V along = b - a;
  const double square = dot(along, along);
  return square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
}

template <class V>
double distance_to_segment(V p, V a, V b) {
  return norm(p - a - nearest_share(p, a, b) * (b - a));
}

/// Whether a closed line of n segments goes round the origin, by the sum of the angles at which they are seen from
/// there. `at(i)`: start of segment i.
template <class At>
bool goes_round_origin(std::size_t n, At at) {
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = at(i), b = at((i + 1) % n);
    turned += std::atan2(cross(a, b), dot(a, b));
  }
  return std::fabs(turned) > M_PI;
}

}  // namespace paver
