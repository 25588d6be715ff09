// Ranges of coordinates.
#pragma once

#include <algorithm>
#include <limits>

#include "paver/vec.h"

namespace paver {

/// Holds nothing at first.
struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};

  bool is_empty() const { return low.x > high.x; }
  void add(Vec3 x) { add(Box{x, x}); }
  void add(Vec2 p) { add(Vec3{p.x, p.y, 0}); }
  void add(const Box& b) {
    low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
    high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
  }
  Box grown(double by) const { return {low - Vec3{by, by, by}, high + Vec3{by, by, by}}; }
  bool meets(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }
};

}  // namespace paver
