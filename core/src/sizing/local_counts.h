// How many elements and facets the lengths of parts ask for.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "sizing/size_field.h"

namespace paver {

/// Box of a face's loops in (u, v).
struct SampleBox {
  Vec2 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void add(Vec2 p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
  }
  bool has_area() const { return hi.x > lo.x && hi.y > lo.y; }
};

SampleBox sample_box(const Model& model, const Face& face);

struct LocalCounts {
  double more_density = 0;  ///< what other parts add to the mean of 1 / h^2 over the box of the face, as rows come out
  double perimeter = 0;     ///< integral of ds / h over its loops
  bool is_graded = false;   ///< other parts shorten h somewhere on the face
};

/// `size` with local lengths; `field` needs h, local and gradation.
LocalCounts count_with_local(const Model& model, const Face& face, const FaceSize& size, const SizeField& field);

}  // namespace paver
