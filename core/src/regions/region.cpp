// Places on a region's surface.
#include "regions/region.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/segment.h"

namespace paver {

NodePlace Region::place(Vec2 p) const {
  NodePlace at;
  at.p = p;
  const auto [uv, uv_x, uv_y] = chart->slope(p);
  const auto [x, xu, xv] = surface->slope(uv);
  at.x = x;
  at.xp = uv_x.x * xu + uv_x.y * xv;
  at.xq = uv_y.x * xu + uv_y.y * xv;
  const NormalTable* normals = size.normals();
  if (!normals) return at;
  at.n = normals->at(uv);
  Vec3 by_u, by_v;
  normals->slopes(uv, {norm(xu), norm(xv)}, by_u, by_v);
  at.np = uv_x.x * by_u + uv_x.y * by_v;
  at.nq = uv_y.x * by_u + uv_y.y * by_v;
  return at;
}

bool are_sides_of_prism(const Region& region, const FacingSides& sides) {
  constexpr double parallel = 0.1;       // radians, of lines and of normals along them
  constexpr double least_bend = 0.5;     // of the limit of turn, in a target length
  constexpr double least_length = 0.55;  // target lengths, in the mean, as lengths count turns
  constexpr double few_rows = 4, least_of_few = 0.3;
  if (sides.size() < 2) return false;
  auto normal = [&](Vec2 p) {
    const SurfaceSlope slope = region.slope(p);
    return unit(cross(slope.u, slope.v));
  };
  Vec3 across;
  double length = 0;
  for (const auto& [one, other] : sides) {
    across += unit(other->x - one->x);
    length += norm(other->x - one->x) / static_cast<double>(sides.size());
  }
  across = unit(across);
  double most = 0, sum = 0;
  Vec3 last;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& [one, other] = sides[i];
    const Vec3 here = normal(one->p);
    if (angle_between(other->x - one->x, across) > parallel || angle_between(here, normal(other->p)) > parallel ||
        angle_between(here, normal(region.chart->between(one->p, other->p, 0.5))) > parallel)
      return false;
    if (i > 0) {
      const double turn = angle_between(last, here), step = norm(one->x - sides[i - 1][0]->x) / region.h;
      most = std::max(most, turn / std::min(step, 1.0));
      sum += std::hypot(step, turn / region.turn_limit);
    }
    last = here;
  }
  const double least = length <= few_rows * region.h ? least_of_few : least_length;
  return most >= least_bend * region.turn_limit && sum >= least * static_cast<double>(sides.size() - 1);
}

double nearest_node(const Region& region, Vec3 at) {
  double nearest = INFINITY;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) nearest = std::min(nearest, norm(node.x - at));
  return nearest;
}

double nearest_facet(const Region& region, Vec3 at) {
  double nearest = INFINITY;
  for (const auto& loop : region.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      nearest = std::min(nearest, distance_to_segment(at, loop[i].x, loop[(i + 1) % loop.size()].x));
  return nearest;
}

double way_round(const Surface& surface, Vec2 uv, double reach) {
  const Vec2 period = surface.period();
  double about_u = period.x > 0 ? 0 : INFINITY, about_v = period.y > 0 ? 0 : INFINITY;
  auto step_of = [&](Vec3 slope) { return norm(slope) > 0 ? reach / norm(slope) : 0; };
  const SurfaceSlope here = surface.slope(uv);
  const Vec2 step{step_of(here.u), step_of(here.v)};
  for (double side : {-1.0, 0.0, 1.0}) {
    if (period.x > 0) about_u = std::max(about_u, norm(surface.slope({uv.x, uv.y + side * step.y}).u) * period.x);
    if (period.y > 0) about_v = std::max(about_v, norm(surface.slope({uv.x + side * step.x, uv.y}).v) * period.y);
  }
  return std::min(about_u, about_v);
}

std::vector<std::vector<int>> find_loop_nodes(const Region& region, const RegionMesh& mesh) {
  std::map<int, std::vector<int>> known;
  for (int node = 0; node < mesh.node_count(); ++node)
    if (mesh.global[node] >= 0) known[mesh.global[node]].push_back(node);
  std::vector<std::vector<int>> found;
  for (const auto& loop : region.loops) {
    std::vector<int>& nodes = found.emplace_back();
    for (const LoopNode& at : loop) {
      const std::vector<int>& copies = known[at.global];
      auto nearest = std::min_element(copies.begin(), copies.end(),
                                      [&](int a, int b) { return norm(mesh.p[a] - at.p) < norm(mesh.p[b] - at.p); });
      nodes.push_back(nearest == copies.end() ? -1 : *nearest);
    }
  }
  return found;
}

int add_node(const Region& region, const LoopNode& known, RegionMesh& mesh) {
  const int node = mesh.add_node(region.place(known.p), known.h);
  mesh.x[node] = known.x;
  mesh.global[node] = known.global;
  mesh.is_fixed[node] = 1;
  return node;
}

int add_node(const Region& region, Vec2 p, RegionMesh& mesh) {
  return mesh.add_node(region.place(p), region.target(p));
}

}  // namespace paver
