// Smoothing beside the front, while rows are laid.
#include "paving/smoothing/smooth_nodes.h"

#include <algorithm>

#include "paving/front/facing.h"
#include "paving/smoothing/fit.h"

namespace paver {
namespace {

constexpr double good_jacobian = 0.7;          // above this a node may trade shape for length
constexpr double shares[] = {1.0, 0.4, 0.15};  // of the step, until one is no worse
constexpr double own_share = 0.5;              // of an element's own size in what it is to become: rows come and go
constexpr double still = 0.01;                 // step by the scale of the mesh that is not worth it

// Mean of where its elements would have it.
MetricVec wished_step(const RegionMesh& mesh, int node) {
  MetricVec sum, step[4];
  for (int i : mesh.star[node]) {
    const Element& e = mesh.elements[i];
    if (fit(mesh, e, own_share, step)) sum += step[e.corner_of(node)];
  }
  return (1.0 / mesh.star[node].size()) * sum;
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
  const MetricVec step = wished_step(mesh, node);
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

void smooth_nodes(Front& front, const std::vector<int>& nodes) {
  constexpr int sweeps = 2;
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
