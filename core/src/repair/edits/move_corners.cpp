// Pattern search: the value of the worst element has kinks, where gradients mislead.
#include "repair/edits/move_corners.h"

#include <algorithm>
#include <cmath>

namespace paver {
namespace {

constexpr int rounds = 7, vain_rounds = 2, directions = 8;
constexpr double first_step = 0.5;  // of the scale of the mesh at the node
constexpr double shrink = 0.6;      // of the step per round

class CornerMover {
 public:
  CornerMover(const ElementJudge& judge, RegionMesh& mesh) : region_(judge.region()), judge_(judge), mesh_(mesh) {}

  /// Looks no further once it is at most `enough`.
  double worst_at(int node, double enough = -2) const {
    double worst = 1;
    for (int e : mesh_.star[node]) {
      worst = std::min(worst, judge_.value(mesh_.elements[e].v, enough));
      if (worst <= enough) break;
    }
    return worst;
  }

  /// Whether it found a better place.
  bool move(int v, double share) {
    const NodePlace from = mesh_.place(v);
    const MetricFrame frame = mesh_.frame(v);
    const double length = share * mesh_.scale_at(v);
    double best = worst_at(v);
    NodePlace at = from;
    for (int i = 0; i < directions; ++i) {
      const double angle = 2 * M_PI * i / directions;
      const Vec2 step = mesh_.pull_back(v, frame.at({length * std::cos(angle), length * std::sin(angle)}));
      const NodePlace place = region_.place(region_.chart->walk(from.p, step));
      mesh_.put(v, place);
      if (const double value = worst_at(v, best); value > best) best = value, at = place;
      mesh_.put(v, from);
    }
    mesh_.put(v, at);
    return at.p != from.p;
  }

 private:
  const Region& region_;
  const ElementJudge& judge_;
  RegionMesh& mesh_;
};

}  // namespace

bool move_corners(const ElementJudge& judge, int element, double least, RegionMesh& mesh) {
  std::vector<int> nodes;
  for (int v : mesh.elements[element].v)
    if (v >= 0 && !mesh.is_fixed[v]) nodes.push_back(v);
  std::vector<NodePlace> places;
  for (int v : nodes) places.push_back(mesh.place(v));
  CornerMover mover(judge, mesh);
  double step = first_step;
  int vain = 0;
  for (int round = 0; round < rounds && vain < vain_rounds; ++round, step *= shrink) {
    bool has_moved = false;
    for (int v : nodes) has_moved |= mover.move(v, step);
    vain = has_moved ? 0 : vain + 1;
  }
  auto is_good = [&](int v) { return mover.worst_at(v) >= least; };
  if (judge.value(element) >= least && std::all_of(nodes.begin(), nodes.end(), is_good)) return true;
  for (std::size_t i = 0; i < nodes.size(); ++i) mesh.put(nodes[i], places[i]);
  return false;
}

}  // namespace paver
