// Places on a region's surface.
#include "regions/region.h"

#include <algorithm>
#include <cmath>

namespace paver {

NodePlace Region::place(Vec2 p) const {
  NodePlace at;
  at.p = p;
  const NormalTable* normals = size.normals();
  if (!normals) {
    evaluate(p, at.x, at.xp, at.xq);
    return at;
  }
  Vec2 uv, uv_x, uv_y;
  Vec3 xu, xv, by_u, by_v;
  chart->to_uv(p, uv, uv_x, uv_y);
  surface->d1(uv, at.x, xu, xv);
  at.xp = uv_x.x * xu + uv_x.y * xv;
  at.xq = uv_y.x * xu + uv_y.y * xv;
  at.n = normals->at(uv);
  normals->slopes(uv, {norm(xu), norm(xv)}, by_u, by_v);
  at.np = uv_x.x * by_u + uv_x.y * by_v;
  at.nq = uv_y.x * by_u + uv_y.y * by_v;
  return at;
}

double nearest_node(const Region& region, Vec3 at) {
  double nearest = INFINITY;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) nearest = std::min(nearest, norm(node.x - at));
  return nearest;
}

int add_node(const Region& region, const LoopNode& known, RegionMesh& mesh) {
  const int node = mesh.add_node(region.place(known.p), known.h);
  mesh.x[node] = known.x;
  mesh.global[node] = known.global;
  mesh.is_fixed[node] = 1;
  return node;
}

}  // namespace paver
