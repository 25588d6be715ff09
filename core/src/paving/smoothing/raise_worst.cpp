// Searches about the nodes of poor elements: one node at a time, in smaller and smaller steps.
#include "paving/smoothing/raise_worst.h"

#include <algorithm>

#include "paving/front/facing.h"
#include "paving/smoothing/search_about.h"

namespace paver {
namespace {

constexpr double shortest = 0.75, longest = 1.35;  // of the target length: sides outside cost
constexpr double length_price = 0.5, most_excess = 0.4;
constexpr double good_jacobian = 0.7;  // shape is never given up for length below this
constexpr double first_step = 0.16;    // target lengths
constexpr int halvings = 4, repeats = 3;

/// What the node's worst side lies outside, target lengths.
double excess(const RegionMesh& mesh, int node) {
  double most = 0;
  for (int e : mesh.star[node]) {
    const double ratio = mesh.relative_length(node, mesh.elements[e].after(node));
    most = std::max({most, shortest - ratio, ratio - longest});
  }
  return most;
}

/// Whether the node has moved.
bool search(Front& front, int node) {
  RegionMesh& mesh = front.mesh;
  double least = -INFINITY;  // scaled Jacobian that a place must have
  auto value = [&](double) -> double {
    const double worst = worst_about(mesh, node);
    if (worst < least || !front.can_move(node, mesh.p[node]) || !faces_surface(front, node)) return -INFINITY;
    return worst - length_price * std::min(excess(mesh, node), most_excess);
  };
  bool has_moved = false;
  double step = first_step * mesh.h[node];
  for (int level = 0; level < halvings; ++level, step *= 0.5)
    for (int repeat = 0; repeat < repeats; ++repeat) {
      least = std::min(worst_about(mesh, node), good_jacobian);
      if (!search_about(front.region, mesh, node, step, value)) break;
      has_moved = true;
    }
  return has_moved;
}

}  // namespace

void raise_worst(Front& front, int rounds) {
  constexpr double goal = 0.74;
  front.end_slides();
  RegionMesh& mesh = front.mesh;
  std::vector<int> nodes, next;
  auto collect = [&](int e) {
    if (!mesh.elements[e].is_alive() || scaled_jacobian(mesh, mesh.elements[e]) >= goal) return;
    for (int v : mesh.elements[e].nodes())
      if (!mesh.is_fixed[v]) next.push_back(v);
  };
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) collect(e);
  for (int round = 0; round < rounds && !next.empty(); ++round) {
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    nodes.swap(next);
    next.clear();
    for (int node : nodes)
      if (search(front, node))
        for (int e : mesh.star[node]) collect(e);
  }
}

}  // namespace paver
