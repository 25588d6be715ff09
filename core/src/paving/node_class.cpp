// Node states from the interior angle and the valence.
#include "paving/node_class.h"

namespace paver {
namespace {

constexpr double deg = M_PI / 180;

struct Limits {
  double end, side, corner;
};

Limits limits(bool is_fixed, int edges) {
  if (is_fixed) return edges <= 3 ? Limits{135 * deg, 225 * deg, 290 * deg} : Limits{110 * deg, 225 * deg, 400 * deg};
  if (edges <= 2) return {135 * deg, 210 * deg, 320 * deg};
  if (edges == 3) return {110 * deg, 240 * deg, 320 * deg};
  return {145 * deg, 225 * deg, 400 * deg};
}

}  // namespace

NodeState classify(const Front& front, int node, double angle) {
  int edges = front.mesh.star[node].size() + 1;
  Limits l = limits(front.mesh.is_fixed[node], edges);
  if (angle < l.end) return NodeState::end;
  if (angle < l.side) return NodeState::side;
  return angle < l.corner ? NodeState::corner : NodeState::reversal;
}

double ambiguity(const Front& front, int node, double angle, NodeState state) {
  double off;
  if (state == NodeState::end) {
    off = std::max(0.0, angle - M_PI / 2) + 0.5 * std::max(0.0, M_PI / 3 - angle);
  } else if (state == NodeState::side) {
    off = std::fabs(angle - M_PI) * (angle > M_PI ? 1.2 : 1.0);
  } else {
    off = std::fabs(angle - (state == NodeState::corner ? 1.5 : 2) * M_PI);
  }
  if (front.mesh.is_fixed[node]) return off;
  int edges = front.mesh.star[node].size() + 1 + static_cast<int>(state);
  double weight = edges == 5 ? 1.15 : (edges == 3 ? 1.3 : (edges <= 2 ? 1.6 : 1.0));
  return off * weight;
}

}  // namespace paver
