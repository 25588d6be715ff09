// Searches about the corners in turn.
#include "repair/edits/move_corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "paving/smoothing/search_about.h"

namespace paver {
namespace {

constexpr int rounds = 7, vain_rounds = 2;
constexpr double first_step = 0.5;  // of the scale of the mesh at the node
constexpr double shrink = 0.6;      // of the step per round

/// Of the elements about a node; looks no further once it is at most `enough`.
double worst_at(const ElementJudge& judge, int v, double enough) {
  double worst = 1;
  for (int e : judge.mesh().star[v]) {
    worst = std::min(worst, judge.value(judge.mesh().elements[e].v, enough));
    if (worst <= enough) break;
  }
  return worst;
}

void search(const ElementJudge& judge, const std::vector<int>& nodes, RegionMesh& mesh) {
  double step = first_step;
  int vain = 0;
  for (int round = 0; round < rounds && vain < vain_rounds; ++round, step *= shrink) {
    bool has_moved = false;
    for (int v : nodes)
      has_moved |= search_about(judge.region(), mesh, v, step * mesh.scale_at(v),
                                [&](double enough) { return worst_at(judge, v, enough); });
    vain = has_moved ? 0 : vain + 1;
  }
}

}  // namespace

bool move_corners(const ElementJudge& judge, int element, double least, RegionMesh& mesh) {
  std::vector<int> nodes;
  for (int v : mesh.elements[element].v)
    if (v >= 0 && !mesh.is_fixed[v]) nodes.push_back(v);
  std::vector<NodePlace> places;
  for (int v : nodes) places.push_back(mesh.place(v));
  search(judge, nodes, mesh);
  auto is_good = [&](int v) { return worst_at(judge, v, -INFINITY) >= least; };
  if (judge.value(element) >= least && std::all_of(nodes.begin(), nodes.end(), is_good)) return true;
  for (std::size_t i = 0; i < nodes.size(); ++i) mesh.put(nodes[i], places[i]);
  return false;
}

void settle_nodes(const ElementJudge& judge, int first, RegionMesh& mesh) {
  std::vector<int> nodes(static_cast<std::size_t>(mesh.node_count() - first));
  std::iota(nodes.begin(), nodes.end(), first);
  search(judge, nodes, mesh);
}

}  // namespace paver
