#include "paving/front/facing.h"

namespace paver {

bool faces_surface(const Front& front, int node) {
  const RegionMesh& mesh = front.mesh;
  for (int e : mesh.star[node])
    if (!faces_surface(mesh, mesh.elements[e])) return false;
  if (front.sectors(node) != 1) return true;
  const NodePlace at = mesh.place(node);
  for (int t = front.empty.facet_side(front.facet_from(node)).triangle; t >= 0; t = front.empty.rotate_ccw(t, node))
    if (is_beyond_facet(front, t, at)) return false;
  return true;
}

bool is_beyond_facet(const Front& front, int t, const NodePlace& at) {
  const RegionMesh& mesh = front.mesh;
  const VoidTriangle& triangle = front.empty.triangle(t);
  for (int i = 0; i < 3; ++i) {
    const int a = triangle.v[(i + 1) % 3], b = triangle.v[(i + 2) % 3];
    if (!is_facet(triangle.n[i]) || !mesh.is_fixed[a] || !mesh.is_fixed[b]) continue;
    // Farther away the surface may have turned: sides say nothing there.
    if (norm(at.x - 0.5 * (mesh.x[a] + mesh.x[b])) > norm(mesh.x[b] - mesh.x[a])) continue;
    const Vec3 normal = mesh.normal(a) + mesh.normal(b) + unit(cross(at.xp, at.xq));
    if (dot(cross(mesh.x[b] - mesh.x[a], at.x - mesh.x[a]), normal) < 0) return true;
  }
  return false;
}

}  // namespace paver
