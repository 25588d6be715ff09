// Each rank answers for the nodes whose number leaves its own rank over, and for the edges whose lower node is such a
// one. Of edges that are not of two elements the owners of both ends hear.
#include "quality/shared_edges.h"

#include <algorithm>
#include <tuple>

#include "base/tasks/gather.h"

namespace paver {
namespace {

/// As it goes from rank to rank.
struct EdgeRecord {
  long low, high, uses;
  double chord;
};
struct NodeRecord {
  long number;
  int twice_valence;  ///< of the corners and edges of one rank
  int is_outside;
};

/// Of an edge that is not of two elements.
struct OddEnd {
  long number, uses;
};

/// Those of the same key become one.
template <class T, class Key, class Add>
void unite(std::vector<T>& all, Key key, Add add) {
  std::ranges::sort(all, {}, key);
  std::size_t count = 0;
  for (const T& one : all) {
    if (count > 0 && key(all[count - 1]) == key(one)) {
      add(all[count - 1], one);
    } else {
      all[count++] = one;
    }
  }
  all.resize(count);
}

void add_odd_end(std::vector<NodeRecord>& nodes, const OddEnd& end) {
  const auto node = std::ranges::lower_bound(nodes, end.number, {}, &NodeRecord::number);
  if (node == nodes.end() || node->number != end.number) return;
  node->twice_valence += static_cast<int>(2 - end.uses);
  if (end.uses == 1) node->is_outside = true;
}

}  // namespace

SharedFigures measure_shared(const SurfaceMesh& mesh, const ShareNumbers& numbers, const EdgeFigures& edges,
                             const std::vector<char>& is_used, const std::vector<char>& is_outside, Ranks& ranks) {
  std::vector<EdgeRecord> shared_edges;
  for (const EdgeUse& edge : edges.shared)
    shared_edges.push_back({numbers.node_number[edge.low], numbers.node_number[edge.high], edge.uses,
                            norm(mesh.nodes[edge.low] - mesh.nodes[edge.high])});
  std::vector<NodeRecord> shared_nodes;
  for (std::size_t i = 0; i < is_used.size(); ++i)
    if (is_used[i] && numbers.is_shared(i))
      shared_nodes.push_back({numbers.node_number[i], edges.twice_valence[i], is_outside[i]});
  std::vector<EdgeRecord> all_edges = deal(shared_edges, ranks, [](const EdgeRecord& edge) { return edge.low; });
  std::vector<NodeRecord> all_nodes = deal(shared_nodes, ranks, [](const NodeRecord& node) { return node.number; });
  unite(
      all_edges, [](const EdgeRecord& edge) { return std::tie(edge.low, edge.high); },
      [](EdgeRecord& edge, const EdgeRecord& more) { edge.uses += more.uses; });
  unite(
      all_nodes, [](const NodeRecord& node) { return node.number; },
      [](NodeRecord& node, const NodeRecord& more) {
        node.twice_valence += more.twice_valence;
        node.is_outside |= more.is_outside;
      });

  SharedFigures figures;
  std::vector<OddEnd> ends;
  for (const EdgeRecord& edge : all_edges) {
    if (edge.uses != 2)
      for (long number : {edge.low, edge.high}) ends.push_back({number, edge.uses});
    figures.chords.push_back(edge.chord);
    figures.border += edge.uses == 1;
    figures.nonmanifold += edge.uses > 2;
  }
  for (const OddEnd& end : deal(ends, ranks, [](const OddEnd& end) { return end.number; })) add_odd_end(all_nodes, end);
  figures.nodes = static_cast<long>(all_nodes.size());
  for (const NodeRecord& node : all_nodes) {
    if (node.twice_valence == 0 || node.is_outside) continue;
    ++figures.face_interior_nodes;
    figures.irregular_nodes += node.twice_valence != 8;
  }
  return figures;
}

}  // namespace paver
