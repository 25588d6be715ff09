// Shape of one straight-sided element: scaled Jacobian at its corners.
//
// Looks at a corner between its next side e and its previous side f (both leaving the corner), against the element's
// unit vector area n:  SJ = (e x f) . n / (|e| |f|).
#include "quality/metrics.h"

#include <algorithm>
#include <array>

namespace paver {
namespace {

double corner_jacobian(Vec3 next, Vec3 previous, Vec3 normal) {
  double lengths = std::sqrt(dot(next, next) * dot(previous, previous));
  return lengths > 0 ? dot(cross(next, previous), normal) / lengths : 0.0;
}

template <std::size_t n>
double least_at_corners(const std::array<Vec3, n>& x, Vec3 normal) {
  std::array<double, n> values;
  for (std::size_t i = 0; i < n; ++i)
    values[i] = corner_jacobian(x[(i + 1) % n] - x[i], x[(i + n - 1) % n] - x[i], normal);
  return *std::min_element(values.begin(), values.end());
}

}  // namespace

double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return least_at_corners<4>({a, b, c, d}, unit(cross(c - a, d - b)));
}

double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c) {
  return triangle_scale * least_at_corners<3>({a, b, c}, unit(cross(b - a, c - a)));
}

}  // namespace paver
