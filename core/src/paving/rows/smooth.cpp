// Smoothing by fitting elements to squares.
#include "paving/rows/smooth.h"

#include <algorithm>

#include "paving/front/facing.h"

namespace paver {
namespace {

constexpr double good_jacobian = 0.7;          // above this a node may trade shape for length
constexpr double shares[] = {1.0, 0.4, 0.15};  // of the step, until one is no worse
constexpr double height_of_unit = 0.8660254;   // of an equilateral triangle of side 1
constexpr double still = 0.01;                 // step by the scale of the mesh that is not worth it

// Steps from corner k to where the element wants it.
MetricVec quad_wish(const RegionMesh& mesh, const Element& e, int k) {
  const int v = e.v[k];
  const MetricVec x1 = mesh.between(v, e.v[(k + 1) % 4]), x2 = mesh.between(v, e.v[(k + 2) % 4]),
                  x3 = mesh.between(v, e.v[(k + 3) % 4]);
  const MetricVec e1 = 0.5 * (x1 + x2 - x3), e2 = 0.5 * (x3 + x2 - x1);
  const MetricFrame frame(e1, e2);
  if (!frame.is_plane) return {};
  const Vec2 one = frame.of(e1), other = frame.of(e2);
  const Vec2 r{one.x + other.y, one.y - other.x};  // the mean of the first and of the second turned back
  const double own = 0.5 * norm(r);
  if (!(own > 0)) return {};
  double target = 0.25 * (mesh.h[e.v[0]] + mesh.h[e.v[1]] + mesh.h[e.v[2]] + mesh.h[e.v[3]]);
  double half = 0.5 * (0.5 * own + 0.5 * target);  // of a square between the element's own and the wished
  const double scale = half / norm(r);
  return 0.25 * (x1 + x2 + x3) + frame.at({scale * (r.y - r.x), scale * (-r.x - r.y)});
}

MetricVec triangle_wish(const RegionMesh& mesh, const Element& e, int k) {
  const int v = e.v[k];
  const MetricVec a = mesh.between(v, e.v[(k + 1) % 3]), b = mesh.between(v, e.v[(k + 2) % 3]), side = b - a;
  const MetricFrame frame(side, -1.0 * a);
  if (!frame.is_plane) return {};
  double target = 0.5 * (mesh.h[e.v[0]] + norm(side));
  return 0.5 * (a + b) + height_of_unit * target * frame.second;
}

double worst_about(const RegionMesh& mesh, int node) {
  double worst = 2;
  for (int e : mesh.star[node]) worst = std::min(worst, scaled_jacobian(mesh, mesh.elements[e]));
  return worst;
}

bool is_good_about(const RegionMesh& mesh, int node) {
  for (int e : mesh.star[node])
    if (!has_jacobian(mesh, mesh.elements[e], good_jacobian)) return false;
  return true;
}

// Does not renew the void about the node.
bool smooth_node(Front& front, int node) {
  RegionMesh& mesh = front.mesh;
  const NodePlace old = mesh.place(node);
  const MetricVec step = ideal_step(mesh, node);
  const double scale = mesh.scale_at(node);
  if (norm(step) < still * scale) return false;
  double before = -2;  // worst scaled Jacobian; worked out when needed
  for (double share : shares) {
    Vec2 p = front.region.chart->walk(old.p, mesh.pull_back(node, share * step));
    if (!front.can_move(node, p)) continue;
    front.slide(node, p, scale);
    const bool is_facing = faces_surface(front, node);
    if (is_facing && is_good_about(mesh, node)) return true;
    double after = worst_about(mesh, node);
    mesh.put(node, old);
    if (before < -1) before = worst_about(mesh, node);
    if (!is_facing || after < before) continue;
    front.slide(node, p, scale);
    return true;
  }
  return false;
}

}  // namespace

MetricVec ideal_step(const RegionMesh& mesh, int node) {
  MetricVec sum;
  int count = 0;
  for (int i : mesh.star[node]) {
    const Element& e = mesh.elements[i];
    int k = e.corner_of(node);
    sum += e.corners() == 4 ? quad_wish(mesh, e, k) : triangle_wish(mesh, e, k);
    ++count;
  }
  return count ? (1.0 / count) * sum : sum;
}

void smooth_nodes(Front& front, const std::vector<int>& nodes, int sweeps) {
  std::vector<int> moved;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int node : nodes)
      if (!front.mesh.is_fixed[node] && front.mesh.star[node].size() > 0 && smooth_node(front, node))
        moved.push_back(node);
  std::sort(moved.begin(), moved.end());
  moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
  front.renew_void(moved);
}

}  // namespace paver
