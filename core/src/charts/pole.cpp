// Eight points about a pole, a thousandth of the meridian from it, and their normals.
#include "charts/pole.h"

#include <algorithm>
#include <cmath>

namespace paver {

PoleShape measure_pole(const Surface& surface, const ParameterBox& box, double period, bool is_low) {
  double pole = is_low ? box.lo.y : box.hi.y, inward = is_low ? 1 : -1;
  PoleShape shape;
  shape.small = 1e-3 * (box.hi.y - box.lo.y);
  shape.apex = surface.point(box.uv({box.lo.x, pole}));
  Vec3 normal[8], mean{0, 0, 0}, point[8];
  for (int i = 0; i < 8; ++i) {
    const auto [x, xu, xv] = surface.slope(box.uv({box.lo.x + period * i / 8, pole + inward * shape.small}));
    point[i] = x, normal[i] = unit(cross(xu, xv));
    mean += normal[i];
  }
  double around = 0;
  for (int i = 0; i < 8; ++i) {
    shape.spread = std::max(shape.spread, std::acos(std::clamp(dot(normal[i], unit(mean)), -1.0, 1.0)));
    shape.slant += 0.125 * norm(point[i] - shape.apex);
    around += norm(point[(i + 1) % 8] - point[i]);
  }
  shape.cone_angle = 1.0263 * around / shape.slant;  // eight chords of a circle to its length
  return shape;
}

}  // namespace paver
