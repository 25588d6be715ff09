// Pattern search about the nodes of poor elements.
#include "paving/smoothing/raise_worst.h"

#include <algorithm>

#include "paving/front/facing.h"

namespace paver {
namespace {

constexpr double shortest = 0.75, longest = 1.35;  // of the target length: sides outside cost
constexpr double length_price = 0.5, most_excess = 0.4;
constexpr double least_gain = 1e-4;
constexpr double first_step = 0.16;  // target lengths
constexpr int halvings = 4, repeats = 3;

struct Merit {
  double worst = 2;   // scaled Jacobian about the node
  double excess = 0;  // what its worst side lies outside, target lengths
  double value() const { return worst - length_price * std::min(excess, most_excess); }
};

Merit merit(const RegionMesh& mesh, int node) {
  Merit m;
  for (int i : mesh.star[node]) {
    const Element& e = mesh.elements[i];
    m.worst = std::min(m.worst, scaled_jacobian(mesh, e));
    int other = e.after(node);
    double ratio = 2 * mesh.length(node, other) / (mesh.h[other] + mesh.h[node]);
    m.excess = std::max(m.excess, std::max(shortest - ratio, ratio - longest));
  }
  return m;
}

// Shape is never given up for length below this.
constexpr double good_jacobian = 0.7;

bool move_if_better(Front& front, int node, Vec2 p, Merit& best) {
  if (!front.can_move(node, p)) return false;
  RegionMesh& mesh = front.mesh;
  const NodePlace old = mesh.place(node), at = front.region.place(p);
  mesh.put(node, at);
  Merit now = merit(mesh, node);
  const bool is_facing = faces_surface(front, node);
  mesh.put(node, old);
  if (!is_facing || now.value() < best.value() + least_gain || now.worst < std::min(best.worst, good_jacobian))
    return false;
  best = now;
  front.set_position(node, at);
  return true;
}

bool search(Front& front, int node) {
  static constexpr double d = 0.70710678118654752;
  static constexpr double directions[8][2] = {{1, 0}, {d, d}, {0, 1}, {-d, d}, {-1, 0}, {-d, -d}, {0, -1}, {d, -d}};
  RegionMesh& mesh = front.mesh;
  Merit best = merit(mesh, node);
  const double start = best.value();
  double step = first_step * mesh.h[node];
  for (int level = 0; level < halvings; ++level, step *= 0.5) {
    bool is_better = true;
    for (int repeat = 0; is_better && repeat < repeats; ++repeat) {
      is_better = false;
      for (auto [du, dw] : directions) {
        Vec2 p = mesh.p[node] + mesh.pull_back(node, mesh.frame(node).at({step * du, step * dw}));
        if (move_if_better(front, node, p, best)) {
          is_better = true;
          break;
        }
      }
    }
  }
  return best.value() > start;
}

}  // namespace

void raise_worst(Front& front, double goal, int rounds) {
  RegionMesh& mesh = front.mesh;
  std::vector<int> nodes, next;
  auto collect = [&](int e) {
    if (!mesh.elements[e].is_alive() || scaled_jacobian(mesh, mesh.elements[e]) >= goal) return;
    for (int v : mesh.elements[e].v)
      if (v >= 0 && !mesh.is_fixed[v]) next.push_back(v);
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
