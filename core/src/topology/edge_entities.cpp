// In: model. Out: entity of every edge, names and groups of the entities.
#include "topology/edge_entities.h"

#include "paver/result.h"

namespace paver {
namespace {

bool is_junction(const Edge& edge) { return edge.faces.size() > 2 && !edge.is_degenerate; }

}  // namespace

EdgeEntities list_edge_entities(const Model& model) {
  EdgeEntities result;
  for (int e = 0; e < model.read_edges; ++e) result.names.push_back("Edge" + std::to_string(e + 1));
  std::vector<char> has_other(result.names.size(), 0);  // pieces that are no junctions
  for (const Edge& edge : model.edges)
    if (!edge.origins.empty() && !is_junction(edge)) has_other[static_cast<std::size_t>(edge.origins.front())] = 1;
  int junction_pieces = 0;
  for (const Edge& edge : model.edges) {
    bool is_own = edge.origins.empty();
    bool is_apart = !is_own && is_junction(edge) && has_other[static_cast<std::size_t>(edge.origins.front())];
    result.of_edge.push_back(is_own || is_apart ? static_cast<int>(result.names.size()) : edge.origins.front());
    if (is_own) result.names.push_back(edge.name);
    if (is_apart) result.names.push_back("Junction" + std::to_string(++junction_pieces));
  }
  result.groups.resize(result.names.size());
  for (std::size_t e = 0; e < model.edges.size(); ++e) {
    std::string& group = result.groups[static_cast<std::size_t>(result.of_edge[e])];
    if (is_junction(model.edges[e])) group = junctions;
    if (model.edges[e].is_wire()) group = model.parts[static_cast<std::size_t>(model.edge_part[e])];
  }
  return result;
}

}  // namespace paver
