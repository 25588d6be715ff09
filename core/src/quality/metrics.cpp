// Shape of one straight-sided element: scaled Jacobian and interior angles at its corners.
//
// Both look at a corner between its next side e and its previous side f (both leaving the corner), against the
// element's unit vector area n:  SJ = (e x f) . n / (|e| |f|),  angle = atan2(|e x f|, e . f), 2 pi less that where the
// corner is turned over.
#include "quality/metrics.h"

#include <algorithm>
#include <numbers>

namespace paver {
namespace {

double corner_jacobian(Vec3 next, Vec3 previous, Vec3 normal) {
  double lengths = std::sqrt(dot(next, next) * dot(previous, previous));
  return lengths > 0 ? dot(cross(next, previous), normal) / lengths : 0.0;
}

double corner_angle(Vec3 next, Vec3 previous, Vec3 normal) {
  Vec3 turn = cross(next, previous);
  double angle = std::atan2(norm(turn), dot(next, previous));
  return dot(turn, normal) < 0 ? 2 * std::numbers::pi - angle : angle;
}

/// Calls f(next side, previous side, n) at every corner and collects what it gives.
template <std::size_t n, class Function>
std::array<double, n> at_corners(const std::array<Vec3, n>& x, Vec3 normal, Function f) {
  std::array<double, n> values;
  for (std::size_t i = 0; i < n; ++i) values[i] = f(x[(i + 1) % n] - x[i], x[(i + n - 1) % n] - x[i], normal);
  return values;
}

Vec3 quad_normal(Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return unit(cross(c - a, d - b)); }
Vec3 triangle_normal(Vec3 a, Vec3 b, Vec3 c) { return unit(cross(b - a, c - a)); }

}  // namespace

double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  auto corners = at_corners<4>({a, b, c, d}, quad_normal(a, b, c, d), corner_jacobian);
  return *std::min_element(corners.begin(), corners.end());
}

double scaled_jacobian(Vec3 a, Vec3 b, Vec3 c) {
  auto corners = at_corners<3>({a, b, c}, triangle_normal(a, b, c), corner_jacobian);
  return triangle_scale * *std::min_element(corners.begin(), corners.end());
}

std::array<double, 4> interior_angles(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return at_corners<4>({a, b, c, d}, quad_normal(a, b, c, d), corner_angle);
}

std::array<double, 3> interior_angles(Vec3 a, Vec3 b, Vec3 c) {
  return at_corners<3>({a, b, c}, triangle_normal(a, b, c), corner_angle);
}

}  // namespace paver
