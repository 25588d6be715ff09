#include "paving/faults.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr double sound_jacobian = 0.05;
constexpr double least_facing = 0.2;  // cosine between an element's normal and the surface's
constexpr double long_side = 0.9;     // of the target length
constexpr double steep = 0.8;         // cosine between a side and a normal

// Thin long elements may lie beneath a bent surface and face the other way, sound as they are by themselves.
bool faces_away(const RegionMesh& mesh, const Element& e) {
  Vec3 normal{0, 0, 0};
  for (int v : e.nodes()) normal += mesh.normal(v);
  Vec3 last = e.corners() == 4 ? mesh.x[e.v[3]] - mesh.x[e.v[1]] : mesh.x[e.v[2]] - mesh.x[e.v[1]];
  return dot(unit(cross(mesh.x[e.v[2]] - mesh.x[e.v[0]], last)), unit(normal)) < least_facing;
}

// A long side that leaves the surface nearly along its normal and comes back to it so runs through the body.
bool cuts_through(const RegionMesh& mesh, const Element& e) {
  for (int k = 0; k < e.corners(); ++k) {
    int a = e.v[k], b = e.v[(k + 1) % e.corners()];
    Vec3 side = mesh.x[b] - mesh.x[a];
    double length = norm(side), out = dot(side, mesh.normal(a)), back = dot(side, mesh.normal(b));
    bool is_steep = out * back < 0 && std::min(std::fabs(out), std::fabs(back)) > steep * length;
    if (is_steep && length > long_side * std::min(mesh.h[a], mesh.h[b])) return true;
  }
  return false;
}

}  // namespace

Faults count_faults(const RegionMesh& mesh) {
  Faults faults;
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    bool is_off = faces_away(mesh, e) || cuts_through(mesh, e);
    faults.off_surface += is_off;
    faults.flat += !is_off && scaled_jacobian(mesh, e) < sound_jacobian;
  }
  return faults;
}

double free_jacobian(const Region& region, const RegionMesh& mesh, const Element& e) {
  unsigned left_out = 0;
  for (int i = 0; i < e.corners(); ++i) {
    const int v = e.v[i];
    if (!mesh.is_fixed[v]) continue;
    auto is_apex = [&](const Fan& fan) { return fan.is_apex && fan.centre.global == mesh.global[v]; };
    const Vec3 ahead = mesh.x[e.v[(i + 1) % e.corners()]] - mesh.x[v];
    const Vec3 behind = mesh.x[e.v[(i + e.corners() - 1) % e.corners()]] - mesh.x[v];
    const bool is_sharp = mesh.star[v].size() == 1 && dot(ahead, behind) > 0;  // else two elements may be better there
    if (is_sharp || std::any_of(region.fans.begin(), region.fans.end(), is_apex)) left_out |= 1U << i;
  }
  return scaled_jacobian(mesh, e, left_out);
}

}  // namespace paver
