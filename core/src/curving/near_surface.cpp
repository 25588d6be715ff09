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
