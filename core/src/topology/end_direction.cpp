#include "topology/end_direction.h"

namespace paver {
namespace {

constexpr double bent = 0.8, straight = 0.95;  // cosines between tangents and the chord
constexpr double behind_bend = 0.4;            // of the way

}  // namespace

Vec3 end_direction(const Curve& curve, double end, double inside, Vec3 chord, double share) {
  auto direction = [&](double at) {
    const Vec3 xt = unit(curve.slope(end + at * (inside - end)).t);
    return inside < end ? -1 * xt : xt;
  };
  const Vec3 way = direction(share);
  if (dot(way, chord) < bent)
    if (const Vec3 behind = direction(behind_bend); dot(behind, chord) > straight) return behind;
  return way;
}

}  // namespace paver
