// All ranks get the lists of all; each answers for the nodes whose number leaves its own rank over, and for the edges
// whose lower node is such a one. It needs the edges at the upper nodes, too, for their valence.
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

/// Edges of the same ends become one.
void unite_edges(std::vector<EdgeRecord>& edges) {
  auto key = [](const EdgeRecord& edge) { return std::tie(edge.low, edge.high); };
  std::sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::size_t count = 0;
  for (const EdgeRecord& edge : edges) {
    if (count > 0 && key(edges[count - 1]) == key(edge)) {
      edges[count - 1].uses += edge.uses;
    } else {
      edges[count++] = edge;
    }
  }
  edges.resize(count);
}

void unite_nodes(std::vector<NodeRecord>& nodes) {
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  std::size_t count = 0;
  for (const NodeRecord& node : nodes) {
    if (count > 0 && nodes[count - 1].number == node.number) {
      nodes[count - 1].twice_valence += node.twice_valence;
      nodes[count - 1].is_outside |= node.is_outside;
    } else {
      nodes[count++] = node;
    }
  }
  nodes.resize(count);
}

void add_odd_edge(std::vector<NodeRecord>& nodes, long number, long uses) {
  auto node = std::lower_bound(nodes.begin(), nodes.end(), number,
                               [](const NodeRecord& record, long value) { return record.number < value; });
  if (node == nodes.end() || node->number != number) return;  // another rank answers for it
  node->twice_valence += static_cast<int>(2 - uses);
  if (uses == 1) node->is_outside = true;
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
  auto is_own = [&](long number) { return number % ranks.count() == ranks.rank(); };
  std::vector<EdgeRecord> all_edges =
      gather_wanted(shared_edges, ranks, [&](const EdgeRecord& edge) { return is_own(edge.low) || is_own(edge.high); });
  std::vector<NodeRecord> all_nodes =
      gather_wanted(shared_nodes, ranks, [&](const NodeRecord& node) { return is_own(node.number); });
  unite_edges(all_edges);
  unite_nodes(all_nodes);

  SharedFigures figures;
  for (const EdgeRecord& edge : all_edges) {
    if (edge.uses != 2) {
      add_odd_edge(all_nodes, edge.low, edge.uses);
      add_odd_edge(all_nodes, edge.high, edge.uses);
    }
    if (!is_own(edge.low)) continue;
    figures.chords.push_back(edge.chord);
    figures.border += edge.uses == 1;
    figures.nonmanifold += edge.uses > 2;
  }
  figures.nodes = static_cast<long>(all_nodes.size());
  for (const NodeRecord& node : all_nodes) {
    if (node.twice_valence == 0 || node.is_outside) continue;
    ++figures.face_interior_nodes;
    figures.irregular_nodes += node.twice_valence != 8;
  }
  return figures;
}

}  // namespace paver
