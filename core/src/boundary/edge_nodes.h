// Every edge divided once, for all its faces.
#pragma once

#include <vector>

#include "base/tasks/shared_tasks.h"
#include "boundary/border/border_facets.h"
#include "paver/progress.h"
#include "sizing/size_field.h"
#include "topology/model.h"

namespace paver {

/// Division of one edge into n intervals: parameters and points at ends and middles.
/// t and x have 2n+1 entries: entry 2i is node i, entry 2i+1 the middle (by arc length) of interval i.
struct EdgeDivision {
  std::vector<double> t;
  std::vector<Vec3> x;
  std::vector<int> node;  ///< n+1 global node indices, from start to end vertex
  int intervals() const { return t.empty() ? 0 : static_cast<int>(t.size() / 2); }
};

/// Nodes on all edges. Global numbering: vertices that are used first, then edge by edge.
struct EdgeNodes {
  std::vector<Vec3> nodes;
  std::vector<int> node_edge;       ///< per node: an edge it lies on
  std::vector<double> node_target;  ///< per node: target length there
  std::vector<EdgeDivision> edges;  ///< per edge of the model; degenerate edges: no intervals
  std::vector<int> node_of_vertex;  ///< per vertex of the model; -1 where no divided edge uses it

  /// The new node's number.
  int add(Vec3 x, int edge, double target) {
    nodes.push_back(x), node_edge.push_back(edge), node_target.push_back(target);
    return static_cast<int>(nodes.size()) - 1;
  }
};

/// How edges are to be divided.
struct EdgeCounts {
  std::vector<int> count;  ///< intervals per edge
  OppositeShares opposite{};
  std::vector<std::vector<int>> together{};  ///< edges that lie along thin faces with equal counts on both sides
};

/// Interval counts per edge: max(1, round(integral of ds/h)), at least 3 on an edge that closes on itself, no interval
/// turning more than the limit; then parity. Collective.
EdgeCounts choose_counts(const Model& model, const SizeField& size, Progress& progress, SharedTasks& tasks,
                         bool all_quad = false);

/// Divides every edge into its count of intervals, equal in integral of ds/h on the exact curve but for places opposite
/// vertices. Collective.
EdgeNodes divide_edges(const Model& model, const SizeField& size, const EdgeCounts& counts, SharedTasks& tasks);

}  // namespace paver
