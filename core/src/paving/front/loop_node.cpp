#include "paving/front/loop_node.h"

#include <cmath>

namespace paver {
namespace {

constexpr double degenerate = 1e-6;      // sine between derivatives: no tangent plane
constexpr double further_inside = 1e-3;  // of the way to the next node
constexpr double clear = 0.3;            // sine between derivatives
constexpr double least_gain = 1.5;       // of the sine: not worth it where the surface is as skew all over
constexpr double inwards[] = {0.004, 0.016, 0.06, 0.25};  // of the way between the neighbours: no farther than need be

/// Between the derivatives; 0 where one of them vanishes.
double sine(const NodePlace& at) {
  const double size = norm(at.xp) * norm(at.xq);
  return size > 0 && std::isfinite(size) ? norm(cross(at.xp, at.xq)) / size : 0;
}

}  // namespace

int add_loop_node(const Region& region, const LoopNode& known, Vec2 towards, bool is_fixed, RegionMesh& mesh) {
  NodePlace at = region.place(known.p);
  if (!(sine(at) > degenerate)) {
    const Vec3 x = at.x;
    at = region.place(known.p + further_inside * (towards - known.p));
    at.p = known.p, at.x = x, at.n = {};
  }
  if (known.global >= 0) at.x = known.x;
  const int node = mesh.add_node(at, known.h);
  mesh.is_fixed[node] = is_fixed, mesh.global[node] = known.global;
  return node;
}

void take_clear_tangents(const Region& region, int node, Vec2 along, RegionMesh& mesh) {
  const NodePlace own = mesh.place(node);
  for (double way : inwards) {
    if (sine(mesh.place(node)) >= clear) return;
    NodePlace inside = region.place(own.p + way * Vec2{-along.y, along.x});
    if (sine(inside) < least_gain * sine(own)) continue;
    inside.p = own.p, inside.x = own.x, inside.n = own.n;
    mesh.put(node, inside);
  }
}

}  // namespace paver
