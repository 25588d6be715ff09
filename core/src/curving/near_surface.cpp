#include "curving/near_surface.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

// Square of the sine between a tangent and the surface; 0 where that has no normal.
double leaning(Vec3 normal, Vec3 tangent) {
  const double off = dot(tangent, normal), all = dot(tangent, tangent) * dot(normal, normal);
  return all > 0 ? off * off / all : 0;
}

/// How far half of a side, from its end `near` to its middle, which is `x` at `m`, lies off the surface, mm; `least`
/// where it is less.
double half_off(const Region& region, const SideEnd& near, const SideEnd& far, Vec2 m, Vec3 x, double least) {
  double most = least;
  Vec2 place = half_way(region, near.p, m);
  for (double t : {0.25, 0.125}) {
    const Vec3 y = (1 - 2 * t) * (1 - t) * near.x + 4 * t * (1 - t) * x - t * (1 - 2 * t) * far.x;
    most = std::max(most, distance_to_surface(region, place, y, norm(far.x - near.x), most));
    place = half_way(region, near.p, place);
  }
  return most;
}

/// Normals at both ends of a side, of any length.
struct Facing {
  Vec3 one, other;
  /// Whether a normal is opposite to both, and these agree: the surface is thin there, and this is its other side.
  bool is_behind(Vec3 normal) const { return dot(normal, one) < 0 && dot(normal, other) < 0 && dot(one, other) > 0; }
  Vec3 mean() const { return unit(one) + unit(other); }
  /// Sine of how far a normal leans from the mean of both to the side of a chord.
  double aside(Vec3 normal, Vec3 chord) const { return dot(unit(normal), unit(cross(chord, mean()))); }
};

/// As nearest_point. Places behind `ends`, if any, are not taken. `normal`: of the surface there, of any length.
Vec3 approach(const Region& region, Vec2& p, Vec3 target, double scale, const Facing* ends, Vec3& normal) {
  constexpr double settled = 1e-4;  // of `scale`: a step along the surface that is not worth an evaluation
  constexpr int most_points = 16;   // with good guesses two or three
  Vec3 nearest;
  Vec2 at = p, step;
  double best = INFINITY;
  for (int i = 0; i < most_points; ++i) {
    const auto [x, xp, xq] = region.slope(at);
    const Vec3 r = target - x;
    const double d = norm(r);
    if (i == 0 || (d <= best * (1 + 1e-12) && !(ends && ends->is_behind(cross(xp, xq))))) {
      nearest = x, best = d, p = at, normal = cross(xp, xq);
      if (!pull_back(xp, xq, r, step) || norm(step.x * xp + step.y * xq) <= settled * scale) break;
    } else {
      step = 0.5 * step;  // the surface bends or is stretched too much on the way
      if (norm(step.x * xp + step.y * xq) <= settled * scale) break;
    }
    at = region.chart->approach(p, step);
  }
  return nearest;
}

struct SurfacePlace {
  Vec2 p;
  Vec3 x, normal;
};

/// Brings a middle of the side from a to b to where its normal leans to neither side. On a tube that bends the chord's
/// middle is nearest to another row of it than that of both ends, and middles would slide round it.
void straighten(const Region& region, const Facing& ends, const SideEnd& a, const SideEnd& b, SurfacePlace& found) {
  constexpr double fair = 0.05;       // sine: 3 degrees
  constexpr double most_share = 1.5;  // of the way from the chord's foot to the place half way
  const Vec3 middle = 0.5 * (a.x + b.x), chord = b.x - a.x;
  auto aside = [&](const SurfacePlace& at) { return ends.aside(at.normal, chord); };
  auto tilt = [&](const SurfacePlace& at) { return std::abs(aside(at)); };
  // About p, as far from one end as from the other.
  auto level = [&](Vec2 p) {
    const Vec3 x = region.point(p);
    SurfacePlace at{p, {}, {}};
    const Vec3 target = x - (dot(x - middle, chord) / dot(chord, chord)) * chord;
    at.x = approach(region, at.p, target, norm(chord), &ends, at.normal);
    return at;
  };
  const double least = tilt(found);
  if (!(least > fair)) return;
  SurfacePlace best = level(half_way(region, a.p, b.p));
  if (tilt(best) > fair) {
    const double one = aside(found), share = one / (one - aside(best));
    if (share > 0 && share < most_share) {
      const SurfacePlace next = level(region.chart->between(found.p, best.p, share));
      if (tilt(next) < tilt(best)) best = next;
    }
  }
  if (tilt(best) < 0.5 * least) found = best;
}

}  // namespace

Vec2 guess_middle(const Region& region, const RegionMesh& mesh, int v, int w, Vec3 off) {
  const SideCubic cubic(mesh, v, w);
  Vec2 step;
  const bool is_found = cubic.is_smooth() &&
                        pull_back(0.5 * (mesh.xp[v] + mesh.xp[w]), 0.5 * (mesh.xq[v] + mesh.xq[w]),
                                  off + 0.125 * (cubic.last - cubic.first), step) &&
                        is_short(step, mesh.p[w] - mesh.p[v]);
  return is_found ? 0.5 * (mesh.p[v] + mesh.p[w]) + step : half_way(region, mesh.p[v], mesh.p[w]);
}

Vec2 guess_centre(const Region& region, const RegionMesh& mesh, const Corners& corners,
                  const std::array<Vec2, 4>& middles) {
  if (region.chart->bends()) return half_way(region, middles[0], middles[2]);
  Vec2 place;
  for (int k = 0; k < 4; ++k) place = place + 0.5 * middles[k] - 0.25 * mesh.p[corners[k]];
  return place;
}

Vec3 nearest_point(const Region& region, Vec2& p, Vec3 target, double scale) {
  Vec3 normal;
  return approach(region, p, target, scale, nullptr, normal);
}

// About a nose at one end a parabola through the middle is flat where the surface turns. Its Jacobian at an end is 4
// times the share of the chord before the middle, less 1: 0.4 of the mean at the limit.
Vec3 side_middle(const Region& region, const SideEnd& a, const SideEnd& b, const Beside& beside, Vec2& p) {
  constexpr double most_leaning = 0.2 * 0.2;
  constexpr double fair_off = 0.02;  // of the target length: even sides serve a solver better than that
  constexpr double shift = 0.05;
  constexpr int most_shifts = 3;
  const Vec3 middle = 0.5 * (a.x + b.x) + beside.bulge, chord = b.x - a.x;
  const double scale = std::min(norm(chord), beside.width);
  const Facing ends{a.normal, b.normal};
  SurfacePlace at{p, {}, {}};
  at.x = approach(region, at.p, middle, scale, &ends, at.normal);
  straighten(region, ends, a, b, at);
  Vec3 x = at.x;
  p = at.p;
  if (leaning(ends.one, 4 * x - 3 * a.x - b.x) <= most_leaning &&
      leaning(ends.other, a.x + 3 * b.x - 4 * x) <= most_leaning)
    return x;
  const double fair = fair_off * std::min(a.h, b.h);
  double least = half_off(region, a, b, p, x, fair), other = half_off(region, b, a, p, x, fair);
  const double way = least > other ? -shift : shift;
  least = std::max(least, other);
  for (int i = 1; i <= most_shifts && least > fair; ++i) {
    Vec2 next = p;
    const Vec3 y = approach(region, next, middle + i * way * chord, scale, &ends, at.normal);
    const double most = std::max(half_off(region, a, b, next, y, fair), half_off(region, b, a, next, y, fair));
    if (!(most < least)) break;
    x = y, p = next, least = most;
  }
  return x;
}

Foot foot_on_surface(const Region& region, Vec2 p, Vec3 target, double scale, const FootSearch& search) {
  constexpr int most_points = 16;
  Foot foot;
  Vec2 at = p, step;
  for (int i = 0; i < most_points; ++i) {
    const auto [x, xp, xq] = region.slope(at);
    const Vec3 r = target - x;
    const double d = norm(r);
    if (!(d < foot.distance)) {
      step = 0.5 * step;
      if (norm(step.x * xp + step.y * xq) <= search.least_halved * scale) break;
    } else {
      foot = {d, cross(xp, xq)}, p = at;
      if (d <= search.known || !pull_back(xp, xq, r, step)) break;
      const double along = norm(step.x * xp + step.y * xq);
      if (along <= search.least_step * scale || along * along <= search.most_turn * scale * d) {
        foot.distance = std::sqrt(std::max(d * d - along * along, 0.0));
        break;
      }
    }
    at = region.chart->approach(p, step);
  }
  return foot;
}

double distance_to_surface(const Region& region, Vec2 p, Vec3 target, double scale, double known) {
  return foot_on_surface(region, p, target, scale, {.known = known}).distance;
}

}  // namespace paver
