// A region on several levels as one mesh: its pieces put together again.
#pragma once

#include <algorithm>
#include <map>

#include "multilevel/multilevel.h"

namespace paver::test {

inline int boundary_nodes_of(const Region& region) {
  int count = 0;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) count = std::max(count, node.global + 1);
  return count;
}

/// Pieces meet in their shared nodes; every one of them must be at the same place in all. Those from number `boundary`
/// on, outline nodes, become nodes inside.
inline RegionMesh put_together(const std::vector<RegionMesh>& pieces, int boundary) {
  RegionMesh whole;
  std::map<int, int> shared;
  for (const RegionMesh& piece : pieces) {
    std::vector<int> number(piece.p.size(), -1);
    for (int v = 0; v < piece.node_count(); ++v) {
      if (piece.star[v].size() == 0) continue;
      const int global = piece.global[v];
      if (auto found = shared.find(global);
          global >= 0 && found != shared.end() && norm(whole.x[found->second] - piece.x[v]) == 0) {
        number[v] = found->second;
        continue;
      }
      number[v] = whole.add_node(piece.p[v], piece.x[v], piece.xp[v], piece.xq[v], piece.h[v]);
      whole.global.back() = global;
      whole.is_fixed.back() = piece.is_fixed[v];
      if (global >= 0) shared[global] = number[v];
    }
    for (const Element& e : piece.elements) {
      if (!e.is_alive()) continue;
      std::array<int, 4> v{-1, -1, -1, -1};
      for (int k = 0; k < e.corners(); ++k) v[k] = number[e.v[k]];
      whole.add_element(v);
    }
  }
  for (int v = 0; v < whole.node_count(); ++v)
    if (whole.global[v] >= boundary) whole.global[v] = -1, whole.is_fixed[v] = 0;
  return whole;
}

/// The mesh of a planar region.
inline RegionMesh pave_on_levels(const Region& region, int multilevel, const Progress& progress,
                                 Elements elements = Elements::quad_dominant) {
  const int boundary = boundary_nodes_of(region);
  auto plan = plan_levels(region, multilevel, boundary, progress, elements);
  if (!plan) return pave_region(region, progress, elements).mesh;
  std::vector<RegionMesh> pieces;
  for (std::size_t i = 0; i < plan->pieces.size(); ++i)
    pieces.push_back(lay_piece(region, without_loops(region), *plan, i, progress, elements).mesh);
  return put_together(pieces, boundary);
}

}  // namespace paver::test
