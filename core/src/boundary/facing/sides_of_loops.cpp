#include "boundary/facing/sides_of_loops.h"

#include <algorithm>
#include <cmath>

#include "topology/corner_angle.h"

namespace paver {
namespace {

constexpr double least_corner = 0.7853981633974483;    // 45 degrees
constexpr double largest_corner = 2.356194490192345;   // 135 degrees
constexpr double least_straight = 2.6179938779914944;  // 150 degrees; from there to 210 a side runs on

}  // namespace

Junction junction_of(double angle) {
  if (angle >= least_corner && angle <= largest_corner) return Junction::corner;
  if (angle >= 2 * M_PI - largest_corner && angle <= 2 * M_PI - least_corner) return Junction::reflex;
  return angle >= least_straight && angle <= 2 * M_PI - least_straight ? Junction::straight : Junction::other;
}

std::vector<double> angles_of(const Model& model, const Face& face, const Loop& loop) {
  const std::size_t n = loop.coedges.size();
  std::vector<double> angles;
  for (const Coedge& coedge : loop.coedges)
    if (!edge_of(model, coedge).curve) return {};
  for (std::size_t i = 0; i < n; ++i) {
    const Coedge &before = loop.coedges[(i + n - 1) % n], &after = loop.coedges[i];
    if (n > 1 && before.edge == after.edge) return {};
    angles.push_back(corner_angle(model, face, before, after));
  }
  return angles;
}

Sides chains_of(const Loop& loop, const std::vector<Junction>& at_nodes) {
  const auto bend = std::ranges::find_if(at_nodes, [](Junction j) { return j != Junction::straight; });
  Sides chains;
  for (std::size_t k = 0, n = at_nodes.size(); k < n; ++k) {
    const std::size_t i = (static_cast<std::size_t>(bend - at_nodes.begin()) + k) % n;
    if (k == 0 || at_nodes[i] != Junction::straight) chains.emplace_back();
    chains.back().push_back(loop.coedges[i].edge);
  }
  return chains;
}

std::optional<Sides> sides_of(const Loop& loop, const std::vector<double>& angles, bool has_reflex) {
  if (angles.empty()) return std::nullopt;
  std::vector<Junction> at_nodes;  // at the start of each coedge
  for (double angle : angles) {
    at_nodes.push_back(junction_of(angle));
    if (has_reflex && at_nodes.back() == Junction::reflex) at_nodes.back() = Junction::corner;
    if (at_nodes.back() != Junction::corner && at_nodes.back() != Junction::straight) return std::nullopt;
  }
  Sides sides = chains_of(loop, at_nodes);
  const bool has_corner = std::ranges::find(at_nodes, Junction::corner) != at_nodes.end();
  if (has_corner && sides.size() == 1) return std::nullopt;  // a drop
  return sides;
}

}  // namespace paver
