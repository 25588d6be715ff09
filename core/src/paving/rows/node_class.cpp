// Node states from the interior angle and the valence.
#include "paving/rows/node_class.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
constexpr double never = 400 * deg;

/// Interior angles up to which a node is an end, a side, a corner; beyond, a reversal.
struct Limits {
  double end, side, corner;
};

/// [Blacker91], by number of edges as in [White97].
Limits limits(bool is_fixed, bool is_passed, int edges) {
  if (is_passed) edges = std::max(edges, 4);  // an end up to 110 degrees only
  if (is_fixed) return edges <= 3 ? Limits{135 * deg, 225 * deg, 290 * deg} : Limits{110 * deg, 225 * deg, never};
  if (edges <= 2) return {135 * deg, 210 * deg, 320 * deg};
  if (edges == 3) return {110 * deg, 240 * deg, 320 * deg};
  return {145 * deg, 225 * deg, never};
}

// Penalties of [White97]: a reflex side costs more than one as far below 180 degrees, and so does a valence off 4.
constexpr double reflex = 1.2, valence_five = 1.15, valence_three = 1.3, valence_two = 1.6;
constexpr double sharpest_end = M_PI / 3, sharp_weight = 0.5;  // ends sharper than this are ambiguous again

}  // namespace

NodeState classify(const Front& front, int node, double angle) {
  int edges = front.mesh.star[node].size() + 1;
  Limits l = limits(front.mesh.is_fixed[node], front.is_passed(node), edges);
  if (angle < l.end) return NodeState::end;
  if (angle < l.side) return NodeState::side;
  return angle < l.corner ? NodeState::corner : NodeState::reversal;
}

double ambiguity(const Front& front, int node, double angle, NodeState state) {
  double off;
  if (state == NodeState::end) {
    off = std::max(0.0, angle - M_PI / 2) + sharp_weight * std::max(0.0, sharpest_end - angle);
  } else if (state == NodeState::side) {
    off = std::fabs(angle - M_PI) * (angle > M_PI ? reflex : 1);
  } else {
    off = std::fabs(angle - (state == NodeState::corner ? 1.5 : 2) * M_PI);
  }
  if (front.mesh.is_fixed[node]) return off;
  int edges = front.mesh.star[node].size() + 1 + static_cast<int>(state);
  double weight = edges == 5 ? valence_five : edges == 3 ? valence_three : edges <= 2 ? valence_two : 1;
  return off * weight;
}

}  // namespace paver
