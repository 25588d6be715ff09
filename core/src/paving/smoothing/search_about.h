// The best of the places about a node: for values with kinks, as that of the worst element, where gradients mislead.
#pragma once

#include <cmath>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// Puts the node at the best of eight places `step` (mm, as lengths count) from where it is; false where none is
/// better. `value(enough)` tells what the mesh about the node is worth as it is; it may stop once that is no more than
/// `enough`.
template <class Value>
bool search_about(const Region& region, RegionMesh& mesh, int node, double step, const Value& value) {
  constexpr int directions = 8;
  constexpr double least_gain = 1e-4;
  const NodePlace from = mesh.place(node);
  const MetricFrame frame = mesh.frame(node);
  NodePlace best = from;
  double most = value(-INFINITY) + least_gain;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * M_PI * i / directions;
    const Vec2 way = mesh.pull_back(node, frame.at({step * std::cos(angle), step * std::sin(angle)}));
    const NodePlace place = region.place(region.chart->walk(from.p, way));
    mesh.put(node, place);
    if (const double now = value(most); now > most) most = now, best = place;
    mesh.put(node, from);
  }
  mesh.put(node, best);
  return !(best.p == from.p);
}

}  // namespace paver
