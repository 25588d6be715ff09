// How large a face is: its box in (u, v), its extent, whether it ends anywhere.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "topology/model.h"

namespace paver {

/// A box in (u, v), empty at first.
struct SampleBox {
  Vec2 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(Vec2 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  void widen(Vec2 by) { lo = lo - by, hi = hi + by; }
  bool contains(Vec2 p) const { return p.x >= lo.x && p.x <= hi.x && p.y >= lo.y && p.y <= hi.y; }
  bool has_area() const { return hi.x > lo.x && hi.y > lo.y; }
  /// The point at shares of its sides.
  Vec2 at(double a, double b) const { return {(1 - a) * lo.x + a * hi.x, (1 - b) * lo.y + b * hi.y}; }
};

/// Of a face's loops.
SampleBox sample_box(const Model& model, const Face& face);

/// Diagonal of a box about the face, mm; infinity where nothing of it can be found.
double face_extent(const Model& model, const Face& face);

/// Whether the face has edges other than its own periodic and degenerate ones.
bool has_border(const Model& model, const Face& face);

}  // namespace paver
