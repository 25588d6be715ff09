// What smoothing wishes for: every element the best of its kind.
#include "paving/smoothing/fit.h"

namespace paver {
namespace {

constexpr double side_share = 0.7;   // of what a side lacks, beside what the square wishes (decision even-lengths)
constexpr double near_target = 0.6;  // length by the target, and target by the length, from which on sides pull
constexpr double collinear = 1e-24;  // square of a diagonal's height over the other, by that one's square

/// Side of the square or triangle to fit.
struct Side {
  double target, own_share;
  double of(double own) const { return target + own_share * (own - target); }
};

// The two diagonals of a square lie a quarter turn apart: the mean of one and of the other turned back is its first.
template <class V>
bool square_steps(const V at[4], Side side, V step[4]) {
  const V centre = 0.25 * (at[0] + at[1] + at[2] + at[3]), d1 = at[2] - at[0], d2 = at[3] - at[1];
  const double first2 = dot(d1, d1), mixed = dot(d1, d2), area2 = first2 * dot(d2, d2) - mixed * mixed;
  if (!(first2 > 0 && area2 > collinear * first2 * first2)) return false;
  const double length = std::sqrt(first2), height = std::sqrt(area2) / length;  // of d2 over d1
  const V f1 = (1 / length) * d1, f2 = (1 / height) * (d2 - (mixed / first2) * d1);
  const double rx = length + height, ry = -mixed / length, own = std::sqrt(rx * rx + ry * ry);
  const double half = M_SQRT1_2 * side.of(M_SQRT1_2 * 0.5 * own) / own;  // half a diagonal, by the length of r
  const V r = (half * rx) * f1 + (half * ry) * f2, q = (-half * ry) * f1 + (half * rx) * f2;
  step[0] = centre - r - at[0], step[1] = centre - q - at[1];
  step[2] = centre + r - at[2], step[3] = centre + q - at[3];
  return true;
}

// The same for the three spokes of an equilateral triangle, a third of a turn apart.
template <class V>
bool triangle_steps(const V at[3], Side side, V step[3]) {
  constexpr double s = 0.86602540378443865;
  const V centre = (1.0 / 3) * (at[0] + at[1] + at[2]), d1 = at[1] - at[0], d2 = at[2] - at[0];
  const double first2 = dot(d1, d1), mixed = dot(d1, d2), area2 = first2 * dot(d2, d2) - mixed * mixed;
  if (!(first2 > 0 && area2 > collinear * first2 * first2)) return false;
  const double length = std::sqrt(first2), height = std::sqrt(area2) / length;
  const V f1 = (1 / length) * d1, f2 = (1 / height) * (d2 - (mixed / first2) * d1);
  auto flat = [&](const V& v) { return Vec2{dot(v, f1), dot(v, f2)}; };
  auto turned = [&](Vec2 v, double sine) { return Vec2{-0.5 * v.x - sine * v.y, sine * v.x - 0.5 * v.y}; };
  const Vec2 sum = flat(at[0] - centre) + turned(flat(at[1] - centre), -s) + turned(flat(at[2] - centre), s);
  const double own = norm(sum);
  if (!(own > 0)) return false;
  const Vec2 r = (side.of(own / (2 * s)) / (2 * s * own)) * sum;
  const Vec2 spokes[3] = {r, turned(r, s), turned(r, -s)};
  for (int k = 0; k < 3; ++k) step[k] = centre + spokes[k].x * f1 + spokes[k].y * f2 - at[k];
  return true;
}

// Squares of the right size leave sides of unequal lengths where rows converge: each side pulls at its ends, too. Not
// in strips that are narrower than elements, where lengths are given: triangles stayed there that pulls would not let
// pair.
template <class V>
void add_side_steps(const V at[], int n, double target, V step[]) {
  V pulls[4];
  for (int k = 0; k < n; ++k) {
    const int next = k + 1 < n ? k + 1 : 0;
    const V side = at[next] - at[k];
    const double length = norm(side);
    if (length < near_target * target || target < near_target * length) return;
    pulls[k] = (0.5 * side_share * (1 - target / length)) * side;
  }
  for (int k = 0; k < n; ++k) {
    const int next = k + 1 < n ? k + 1 : 0;
    step[k] = step[k] + pulls[k], step[next] = step[next] - pulls[k];
  }
}

// In the metric skew of elements that turns stretch counts for little: in space their short mid line is to be square to
// the long one, as far as the metric has it longer than space.
void add_square_steps_in_space(const MetricVec at[4], MetricVec step[4]) {
  const MetricVec across = 0.5 * (at[1] + at[2] - at[0] - at[3]), up = 0.5 * (at[2] + at[3] - at[0] - at[1]);
  const bool is_wide = dot(across.x, across.x) > dot(up.x, up.x);
  const MetricVec &wide = is_wide ? across : up, &narrow = is_wide ? up : across;
  const double wide2 = dot(wide.x, wide.x), narrow2 = dot(narrow, narrow);
  if (!(wide2 > 0 && narrow2 > 0)) return;
  const double share = 1 - dot(narrow.x, narrow.x) / narrow2;
  const Vec3 shift = (0.5 * share * dot(wide.x, narrow.x) / wide2) * wide.x;
  for (int k = 0; k < 4; ++k) {
    const bool is_ahead = is_wide ? k >= 2 : k == 1 || k == 2;
    step[k].x = is_ahead ? step[k].x - shift : step[k].x + shift;
  }
}

double mean_target(const RegionMesh& mesh, const Element& e) {
  double sum = 0;
  for (int v : e.nodes()) sum += mesh.h[v];
  return sum / e.corners();
}

bool fit(const RegionMesh& mesh, const Element& e, Side side, bool is_even, MetricVec step[4]) {
  const int n = e.corners();
  if (mesh.has_turns()) {
    const MetricVec at[4] = {{},
                             mesh.between(e.v[0], e.v[1]),
                             mesh.between(e.v[0], e.v[2]),
                             n == 4 ? mesh.between(e.v[0], e.v[3]) : MetricVec{}};
    if (!(n == 4 ? square_steps(at, side, step) : triangle_steps(at, side, step))) return false;
    if (is_even) add_side_steps(at, n, side.target, step);
    if (n == 4) add_square_steps_in_space(at, step);
    return true;
  }
  const Vec3 at[4] = {mesh.x[e.v[0]], mesh.x[e.v[1]], mesh.x[e.v[2]], n == 4 ? mesh.x[e.v[3]] : Vec3{}};
  Vec3 flat[4];
  if (!(n == 4 ? square_steps(at, side, flat) : triangle_steps(at, side, flat))) return false;
  if (is_even) add_side_steps(at, n, side.target, flat);
  for (int k = 0; k < n; ++k) step[k] = {flat[k], {}};
  return true;
}

}  // namespace

bool fit(const RegionMesh& mesh, const Element& e, double own_share, MetricVec step[4]) {
  return fit(mesh, e, {mean_target(mesh, e), own_share}, false, step);
}

bool fit_evenly(const RegionMesh& mesh, const Element& e, MetricVec step[4]) {
  return fit(mesh, e, {mean_target(mesh, e), 0}, true, step);
}

}  // namespace paver
