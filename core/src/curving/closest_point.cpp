// Nearest point of a surface, by Newton's method on the squared distance.
// In: guess and target. Out: (u, v) and point.
// Steps: Newton direction where the Hessian is positive, else Gauss-Newton; step bounded by the guess's distance;
// halved until the distance does not grow.
// Known limit: it knows no bounds of the surface, so a B-spline may be followed past its end.
#include "curving/closest_point.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr int most_iterations = 10;
constexpr int most_halvings = 8;
constexpr double step_tolerance = 1e-12;  // of the guess's distance from the target
constexpr double rounding = 1e-15;        // of the coordinates: no step below this means anything
constexpr double singular = 1e-14;        // det / (e g) below which the tangents are parallel
constexpr double longest_step = 2;        // in distances of the guess from the target
constexpr double orthogonality = 1e-8;    // cosine of the final residual to the tangents

bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

struct State {
  Vec2 uv;
  Vec3 x, xu, xv, residual;
  double distance = 0;
};

struct Step {
  Vec2 uv;
  double length = 0;  // in space
  bool is_singular = false;
};

// Solves [a b; b c] d = g by Cramer's rule.
Vec2 solve(double a, double b, double c, Vec2 g, double determinant) {
  return {(g.x * c - g.y * b) / determinant, (g.y * a - g.x * b) / determinant};
}

Step newton_step(const Surface& surface, State& state, Vec3 target) {
  Vec3 xuu, xuv, xvv;
  surface.d2(state.uv, state.x, state.xu, state.xv, xuu, xuv, xvv);
  state.residual = target - state.x;
  state.distance = norm(state.residual);
  const Vec3 &xu = state.xu, &xv = state.xv, &r = state.residual;
  double e = dot(xu, xu), f = dot(xu, xv), g = dot(xv, xv);
  double gram = e * g - f * f;
  Step step;
  step.is_singular = !(gram > singular * e * g) || !is_finite(r);
  if (step.is_singular) return step;
  Vec2 slope{dot(r, xu), dot(r, xv)};
  double a = e - dot(r, xuu), b = f - dot(r, xuv), c = g - dot(r, xvv);
  double hessian = a * c - b * b;
  // Far from positive definite Newton's method may run to a saddle or a maximum.
  bool is_convex = a > 0 && hessian > 0.01 * gram;
  step.uv = is_convex ? solve(a, b, c, slope, hessian) : solve(e, f, g, slope, gram);
  step.length = norm(step.uv.x * xu + step.uv.y * xv);
  return step;
}

}  // namespace

bool closest_on_surface(const Surface& surface, Vec2& uv, Vec3 target, Vec3& x) {
  State state;
  state.uv = uv;
  Step step = newton_step(surface, state, target);
  if (!is_finite(state.x)) return false;
  x = state.x;
  const double first_distance = state.distance;
  const double size = std::max({std::abs(target.x), std::abs(target.y), std::abs(target.z)});
  const double tolerance = std::max(step_tolerance * first_distance, rounding * size);

  for (int iteration = 0; iteration < most_iterations && !step.is_singular; ++iteration) {
    bool is_small = step.length <= tolerance;
    double share = step.length > longest_step * first_distance ? longest_step * first_distance / step.length : 1;
    State next;
    bool has_moved = false;
    for (int halving = 0; halving <= most_halvings && !has_moved; ++halving, share *= 0.5) {
      next.uv = state.uv + share * step.uv;
      if (next.uv == state.uv) break;
      Vec3 there = surface.point(next.uv);
      has_moved = is_finite(there) && norm(target - there) <= state.distance + tolerance;
    }
    if (has_moved) {
      step = newton_step(surface, next, target);
      state = next;
      uv = state.uv;
      x = state.x;
    }
    if (is_small || !has_moved) break;
  }
  double along_u = std::abs(dot(state.residual, state.xu)), along_v = std::abs(dot(state.residual, state.xv));
  return !step.is_singular && along_u <= norm(state.xu) * (orthogonality * first_distance + 10 * tolerance) &&
         along_v <= norm(state.xv) * (orthogonality * first_distance + 10 * tolerance);
}

}  // namespace paver
