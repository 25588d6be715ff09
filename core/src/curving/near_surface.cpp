#include "curving/near_surface.h"

#include <algorithm>
#include <cmath>

namespace paver {

Vec2 guess_middle(const RegionMesh& mesh, int v, int w, Vec3 off) {
  const Vec2 middle = 0.5 * (mesh.p[v] + mesh.p[w]);
  const SideCubic cubic(mesh, v, w);
  Vec2 step;
  const bool is_found = cubic.is_smooth() &&
                        pull_back(0.5 * (mesh.xp[v] + mesh.xp[w]), 0.5 * (mesh.xq[v] + mesh.xq[w]),
                                  off + 0.125 * (cubic.last - cubic.first), step) &&
                        is_short(step, mesh.p[w] - mesh.p[v]);
  return is_found ? middle + step : middle;
}

Vec3 nearest_point(const Region& region, Vec2& p, Vec3 target, double scale) {
  constexpr double settled = 1e-4;  // of `scale`: a step along the surface that is not worth an evaluation
  Vec3 nearest, x, xp, xq;
  Vec2 at = p, step;
  double best = INFINITY;
  for (int i = 0; i < 7; ++i) {
    region.evaluate(at, x, xp, xq);
    const Vec3 r = target - x;
    const double d = norm(r);
    if (i > 0 && !(d <= best * (1 + 1e-12))) break;
    nearest = x, best = d, p = at;
    if (!pull_back(xp, xq, r, step) || norm(step.x * xp + step.y * xq) <= settled * scale) break;
    at = at + step;
  }
  return nearest;
}

double distance_to_surface(const Region& region, Vec2 p, Vec3 target, double scale, double known) {
  constexpr int most_steps = 6;
  constexpr double most_turn = 1e-4;  // of the distance, as far as the surface turns by one on the scale
  double best = INFINITY;
  for (int i = 0; i <= most_steps; ++i) {
    Vec3 x, xp, xq;
    region.evaluate(p, x, xp, xq);
    Vec3 r = target - x;
    double d = norm(r);
    if (!(d < best)) break;
    best = d;
    Vec2 step;
    if (d <= known || !pull_back(xp, xq, r, step)) break;
    double along = norm(step.x * xp + step.y * xq);
    if (along * along <= most_turn * scale * d) return std::sqrt(std::max(d * d - along * along, 0.0));
    p = p + step;
  }
  return best;
}

}  // namespace paver
