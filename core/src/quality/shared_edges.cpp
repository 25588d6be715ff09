// All ranks get the lists of all; each answers for the nodes whose number leaves its own rank over, and for the edges
// whose lower node is such a one. It needs the edges at the upper nodes, too, for their valence.
#include "quality/shared_edges.h"

#include <algorithm>
#include <cstring>
#include <tuple>

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

struct Lists {
  std::vector<EdgeRecord> edges;
  std::vector<NodeRecord> nodes;
};

Lists lists_of(const MeshShare& share, const EdgeFigures& edges, const std::vector<char>& is_used,
               const std::vector<char>& is_outside) {
  Lists lists;
  const std::vector<Vec3>& nodes = share.result.mesh.nodes;
  for (const EdgeUse& edge : edges.shared) {
    lists.edges.push_back({share.node_number[edge.low], share.node_number[edge.high], edge.uses,
                           norm(nodes[edge.low] - nodes[edge.high])});
  }
  for (std::size_t i = 0; i < is_used.size(); ++i) {
    if (is_used[i] && share.is_shared_node[i])
      lists.nodes.push_back({share.node_number[i], edges.twice_valence[i], is_outside[i]});
  }
  return lists;
}

template <class T>
void append(const std::vector<T>& list, std::string& bytes) {
  long count = static_cast<long>(list.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
}

/// Takes a list off the front of `bytes` and adds those entries that are wanted to `list`.
template <class T, class Wanted>
void take(std::string_view& bytes, std::vector<T>& list, Wanted is_wanted) {
  long count;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  for (; count > 0; --count) {
    T entry;
    std::memcpy(&entry, bytes.data(), sizeof entry);
    bytes.remove_prefix(sizeof entry);
    if (is_wanted(entry)) list.push_back(entry);
  }
}

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

SharedFigures measure_shared(const MeshShare& share, const EdgeFigures& edges, const std::vector<char>& is_used,
                             const std::vector<char>& is_outside, Ranks& ranks) {
  std::string mine;
  {
    Lists lists = lists_of(share, edges, is_used, is_outside);
    append(lists.edges, mine);
    append(lists.nodes, mine);
  }
  auto is_own = [&](long number) { return number % ranks.count() == ranks.rank(); };
  Lists all;
  for (std::string_view bytes : ranks.gather(mine)) {
    take(bytes, all.edges, [&](const EdgeRecord& edge) { return is_own(edge.low) || is_own(edge.high); });
    take(bytes, all.nodes, [&](const NodeRecord& node) { return is_own(node.number); });
  }
  unite_edges(all.edges);
  unite_nodes(all.nodes);

  SharedFigures figures;
  for (const EdgeRecord& edge : all.edges) {
    if (edge.uses != 2) {
      add_odd_edge(all.nodes, edge.low, edge.uses);
      add_odd_edge(all.nodes, edge.high, edge.uses);
    }
    if (!is_own(edge.low)) continue;
    figures.chords.push_back(edge.chord);
    figures.border += edge.uses == 1;
    figures.nonmanifold += edge.uses > 2;
  }
  figures.nodes = static_cast<long>(all.nodes.size());
  for (const NodeRecord& node : all.nodes) {
    if (node.twice_valence == 0 || node.is_outside) continue;
    ++figures.face_interior_nodes;
    figures.irregular_nodes += node.twice_valence != 8;
  }
  return figures;
}

}  // namespace paver
