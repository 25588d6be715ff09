// The charts: rows of constant v side by side, or polar about a pole or an axis.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "brep/surfaces/surface.h"
#include "paver/vec.h"

namespace paver {

/// (u, v) at a chart point and its derivatives by the chart coordinates.
struct ChartSlope {
  Vec2 uv, by_x, by_y;
};

/// Injective map between a region's (u, v) and a plane in which orientation tests are exact.
class Chart {
 public:
  virtual ~Chart() = default;
  virtual Vec2 to_chart(Vec2 uv) const = 0;
  virtual ChartSlope slope(Vec2 p) const = 0;
  Vec2 uv(Vec2 p) const { return slope(p).uv; }
  /// End of the walk that starts at p with the chart displacement `step`; to first order p + step. Charts that bend
  /// long straight walks on the surface follow them here.
  virtual Vec2 walk(Vec2 p, Vec2 step) const { return p + step; }
  /// Where a step of a search leads: as walk(), but never across an apex, about which the chart is a power of the
  /// distance.
  virtual Vec2 approach(Vec2 p, Vec2 step) const { return walk(p, step); }
  /// Whether walk() is more than p + step.
  virtual bool bends() const { return false; }
  /// The step of the walk from p to q: walk(p, step_to(p, q)) == q.
  virtual Vec2 step_to(Vec2 p, Vec2 q) const { return q - p; }
  /// So much of the walk from p to q.
  Vec2 between(Vec2 p, Vec2 q, double share) const { return walk(p, share * step_to(p, q)); }
};

/// Surface point at a chart point and its derivatives by the chart coordinates.
inline SurfaceSlope slope_at(const ChartSlope& at, const Surface& surface) {
  const auto [x, xu, xv] = surface.slope(at.uv);
  return {x, at.by_x.x * xu + at.by_x.y * xv, at.by_y.x * xu + at.by_y.y * xv};
}
inline SurfaceSlope slope_at(const Chart& chart, const Surface& surface, Vec2 p) {
  return slope_at(chart.slope(p), surface);
}

/// Step in the chart whose image comes nearest to r, by the derivatives there; false where these are parallel.
inline bool pull_back(Vec3 xp, Vec3 xq, Vec3 r, Vec2& step) {
  const double a = dot(xp, xp), b = dot(xp, xq), c = dot(xq, xq), det = a * c - b * b;
  if (!(det > 1e-12 * a * c)) return false;
  const double s = dot(r, xp), t = dot(r, xq);
  step = {(c * s - b * t) / det, (a * t - b * s) / det};
  return true;
}

/// Box of a face's (u, v) and how its sides close.
struct ParameterBox {
  Vec2 lo, hi;
  bool is_swapped = false;                   ///< rows run along v: u and v have changed places in what follows
  bool low_pole = false, high_pole = false;  ///< all of the side at lo.y (hi.y) is one point

  /// (u, v) of a place in the box, or the place of (u, v).
  Vec2 uv(Vec2 place) const { return is_swapped ? Vec2{place.y, place.x} : place; }
  /// Below and above a cut at y, which is no pole.
  std::array<ParameterBox, 2> halves(double y) const;
};

inline std::array<ParameterBox, 2> ParameterBox::halves(double y) const {
  return {{{lo, {hi.x, y}, is_swapped, low_pole, false}, {{lo.x, y}, hi, is_swapped, false, high_pole}}};
}

/// Mean |S_u| and arc length along v, tabulated over the box: what both charts are scaled by.
class MeridianTable {
 public:
  MeridianTable(const Surface& surface, const ParameterBox& box, int cells);
  double lo() const { return lo_; }
  double step() const { return step_; }
  int cells() const { return static_cast<int>(width_.size()) - 1; }
  /// Mean |S_u| at sample i.
  double width(int i) const { return width_[i]; }
  /// Mean |S_v| over cell i.
  double height(int i) const { return height_[i]; }
  const std::vector<double>& heights() const { return height_; }

 private:
  double lo_, step_;
  std::vector<double> width_, height_;
};

/// p = ((u - u_mid) A(v), S(v)): isometric on planes, cylinders; poles become points. Where rows start or end slowly
/// the length along them has u's place.
std::shared_ptr<const Chart> make_row_chart(const Surface& surface, const ParameterBox& box);

/// p = R(v) (cos phi, sin phi), phi once around per period of u, R so that the map is about conformal: the periodic
/// edge disappears and a pole is an ordinary point. Null when the radii would span too many orders of magnitude.
std::shared_ptr<const Chart> make_polar_chart(const Surface& surface, const ParameterBox& box, double period);

}  // namespace paver
