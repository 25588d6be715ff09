// In: model. Out: entity of every edge, names and groups of the entities.
#include <algorithm>

#include "entries/names.h"

namespace paver {
namespace {

/// The name that users gave goes before others.
std::string group_of(const Model& model, std::size_t index) {
  const Edge& edge = model.edges[index];
  for (int origin : edge.origins)
    if (static_cast<std::size_t>(origin) < model.edge_group.size() && !model.edge_group[origin].empty())
      return model.edge_group[origin];
  if (const int wire = model.edge_part[index]; wire >= 0) return model.parts[wire];
  return edge.faces.size() > 2 && !edge.is_degenerate ? junctions : "";
}

/// Which pieces of an edge keep its number: first those in no group, then those in a group of a name.
int rank_of(const std::string& group) { return group.empty() ? 0 : group == junctions ? 2 : 1; }

}  // namespace

EdgeEntities list_edge_entities(const Model& model) {
  constexpr int none = 3;
  EdgeEntities result;
  for (int e = 0; e < model.read_edges; ++e) result.names.push_back("Edge" + std::to_string(e + 1));
  result.groups.resize(result.names.size());
  std::vector<int> keeps(result.names.size(), none);  // per edge as read: rank of the pieces that keep its number
  std::vector<std::string> group;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    group.push_back(group_of(model, e));
    for (int origin : model.edges[e].origins) {
      int& least = keeps[origin];
      least = std::min(least, rank_of(group[e]));
    }
  }
  int junction_pieces = 0, named_pieces = 0;
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    const Edge& edge = model.edges[e];
    const int first = edge.origins.empty() ? -1 : edge.origins.front(), rank = rank_of(group[e]);
    if (first >= 0 && keeps[first] == rank) {
      result.of_edge.push_back(first);
      result.groups[first] = group[e];
      continue;
    }
    result.of_edge.push_back(static_cast<int>(result.names.size()));
    result.groups.push_back(group[e]);
    result.names.push_back(first < 0   ? edge.name
                           : rank == 2 ? "Junction" + std::to_string(++junction_pieces)
                                       : "Piece" + std::to_string(++named_pieces));
  }
  return result;
}

}  // namespace paver
