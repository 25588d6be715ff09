#include "curving/edge_bulges.h"

#include <algorithm>

namespace paver {

void EdgeBulges::add(int a, Vec3 xa, int b, Vec3 xb, Vec3 middle) {
  const Vec3 by = middle - 0.5 * (xa + xb);
  from_[a].push_back({b, xb, by});
  from_[b].push_back({a, xa, by});
}

EdgeBulges::Mean EdgeBulges::mean_from(const SideEnd& from, const SideEnd& to) const {
  Mean mean;
  if (from.global < 0) return mean;
  const auto found = from_.find(from.global);
  if (found == from_.end()) return mean;
  double sum = 0;
  for (const Bulge& side : found->second) {
    const Vec3 off = side.at - to.x, chord = to.x - from.x;
    const double share = 1 - 4 * dot(off, off) / dot(chord, chord);
    if (!(share > 0) || side.end == to.global) continue;
    mean.share = std::max(mean.share, share);
    mean.off += share * off, mean.by += share * side.by, sum += share;
  }
  if (sum > 0) mean.off = (1 / sum) * mean.off, mean.by = (1 / sum) * mean.by, mean.width = norm(mean.off);
  return mean;
}

// Between two edges a parabola with the mean bulge leaves the first as fast as these are apart at the other end, less
// twice the difference of the bulges. So where that matters it bends to where they are farther apart.
Beside EdgeBulges::beside(const SideEnd& a, const SideEnd& b) const {
  const Mean one = mean_from(a, b), other = mean_from(b, a);
  Beside beside{{}, std::min(one.width, other.width)};
  if (beside.width == INFINITY) return beside;
  const double both = std::min(one.share, other.share);
  beside.bulge =
      (1 / (one.share + other.share)) * ((one.share * one.share) * one.by + (other.share * other.share) * other.by);
  if (both == 0) return beside;
  const Vec3 chord = b.x - a.x, bend = one.off + other.off;
  const double differ = 8 * norm(one.by - other.by), widths = one.width + other.width;
  const double share = both * (widths > differ ? differ / widths : 1);
  beside.bulge += (0.125 * share) * (bend - (dot(bend, chord) / dot(chord, chord)) * chord);
  return beside;
}

}  // namespace paver
