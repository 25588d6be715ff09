// The charts: rows of constant v side by side, or polar about a pole or an axis.
#pragma once

#include <memory>
#include <vector>

#include "regions/region.h"

namespace paver {

/// Box of a face's (u, v) and how its sides close.
struct ParameterBox {
  Vec2 lo, hi;
  bool is_swapped = false;                   ///< rows run along v: u and v have changed places in what follows
  bool low_pole = false, high_pole = false;  ///< all of the side at lo.y (hi.y) is one point
};

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

 private:
  double lo_, step_;
  std::vector<double> width_, height_;
};

/// p = ((u - u_mid) A(v), S(v)): isometric on planes, cylinders; poles become points.
std::shared_ptr<const Chart> make_row_chart(const Surface& surface, const ParameterBox& box);

/// p = R(v) (cos phi, sin phi), phi once around per period of u, R so that the map is about conformal: the periodic
/// edge disappears and a pole is an ordinary point. Null when the radii would span too many orders of magnitude.
std::shared_ptr<const Chart> make_polar_chart(const Surface& surface, const ParameterBox& box, double period);

}  // namespace paver
