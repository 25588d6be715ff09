#include "entries/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/listed.h"

namespace paver {

void name_edges(const Model& model, MeshResult& result) {
  const EdgeEntities entities = list_edge_entities(model);
  result.edge_names = entities.names;
  result.edge_groups = entities.groups;
  SurfaceMesh& mesh = result.mesh;
  for (std::size_t line = 0; line < mesh.line_edge.size(); ++line) {
    int edge = mesh.line_edge[line];
    mesh.line_edge[line] = entities.of_edge[edge];
    for (int origin : model.edges[edge].origins)
      if (origin != mesh.line_edge[line]) mesh.further_edges.push_back({static_cast<int>(line), origin});
  }
  for (int& edge : mesh.node_edge)
    if (edge >= 0) edge = entities.of_edge[edge];
}

void name_points(const Model& model, MeshResult& result) {
  std::vector<int> nodes;
  std::vector<std::string> lost;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const int node = result.mesh.points[i];
    const std::string& name = model.points[i].name;
    if (node < 0) {
      if (!model.points[i].is_apart) lost.push_back(name);
      continue;
    }
    nodes.push_back(node);
    result.point_names.push_back(name);
  }
  result.mesh.points = std::move(nodes);
  if (!lost.empty())
    result.report.notes.push_back(
        fmt::format("Points without a node, as nothing was meshed there: {}.", listed(lost, lost.size())));
}

void count_wire_lines(const Model& model, MeshResult& result) {
  for (int edge : result.mesh.line_edge) result.report.quality.wire_lines += is_of_wire(model, edge);
}

void measure_segments(const Options& options, MeshResult& result) {
  const SurfaceMesh& mesh = result.mesh;
  for (std::size_t line = 0; line < mesh.line_edge.size(); ++line)
    for (const Wire& wire : options.wires) {
      if (result.edge_groups[mesh.line_edge[line]] != wire.name) continue;
      const auto nodes = mesh.line(line);
      const double segment = norm(mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]) / wire.radius;
      std::optional<double>& least = result.report.least_segment;
      least = std::min(segment, least.value_or(segment));
    }
}

}  // namespace paver
