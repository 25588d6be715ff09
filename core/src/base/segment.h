// Points beside straight segments.
#pragma once

#include <algorithm>

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

}  // namespace paver
