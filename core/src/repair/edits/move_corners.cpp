// Searches about the corners in turn.
#include "repair/edits/move_corners.h"

#include <algorithm>
#include <cmath>

#include "paving/smoothing/fit.h"
#include "paving/smoothing/search_about.h"
#include "repair/edits/patch.h"

namespace paver {
namespace {

constexpr int rounds = 7, vain_rounds = 2;
constexpr double first_step = 0.5;  // of the scale of the mesh at the node
constexpr double shrink = 0.6;      // of the step per round
constexpr int sweeps = 10;
constexpr double good = 0.4;                   // value of the worst element about a node that goes on
constexpr double shares[] = {1.0, 0.5, 0.25};  // of its step, until one keeps that
constexpr double own_share = 0;                // lengths are to become target lengths

/// Of the elements about a node; looks no further once it is at most `enough`.
double worst_at(const ElementJudge& judge, int v, double enough) {
  double worst = 1;
  for (int e : judge.mesh().star[v]) {
    worst = std::min(worst, judge.value(judge.mesh().elements[e].v, enough));
    if (worst <= enough) break;
  }
  return worst;
}

void towards_length(const ElementJudge& judge, int v, RegionMesh& mesh) {
  MetricVec sum, step[4];
  for (int e : mesh.star[v])
    if (fit(mesh, mesh.elements[e], own_share, step)) sum += step[mesh.elements[e].corner_of(v)];
  sum = (1.0 / mesh.star[v].size()) * sum;
  const double least = std::min(good, worst_at(judge, v, -INFINITY));
  const NodePlace from = mesh.place(v);
  for (double share : shares) {
    mesh.put(v, judge.region().place(judge.region().chart->walk(from.p, mesh.pull_back(v, share * sum))));
    if (worst_at(judge, v, -INFINITY) >= least) return;
    mesh.put(v, from);
  }
}

}  // namespace

void raise_worst_about(const ElementJudge& judge, const std::vector<int>& nodes, RegionMesh& mesh) {
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

bool move_corners(const ElementJudge& judge, int element, double least, RegionMesh& mesh) {
  const std::vector<int> nodes = free_corners(mesh, element);
  std::vector<NodePlace> places;
  for (int v : nodes) places.push_back(mesh.place(v));
  raise_worst_about(judge, nodes, mesh);
  auto is_good = [&](int v) { return worst_at(judge, v, -INFINITY) >= least; };
  if (judge.value(element) >= least && std::all_of(nodes.begin(), nodes.end(), is_good)) return true;
  for (std::size_t i = 0; i < nodes.size(); ++i) mesh.put(nodes[i], places[i]);
  return false;
}

void even_out(const ElementJudge& judge, const std::vector<int>& nodes, RegionMesh& mesh) {
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int v : nodes) towards_length(judge, v, mesh);
}

}  // namespace paver
