#include "entries/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/local_parts.h"
#include "topology/named_parts.h"

namespace paver {
namespace {

bool has(const std::vector<int>& list, int value) { return std::find(list.begin(), list.end(), value) != list.end(); }

}  // namespace

std::vector<Volume> list_volumes(const Model& model) {
  std::vector<Volume> volumes;
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    const int part = static_cast<int>(p);
    const std::string medium = medium_of(model, {part});
    if (medium.empty()) continue;
    std::map<int, std::set<int>> sides;  // by entry
    for (const Face& face : model.faces)
      if (face.is_meshed()) sides[face.origin].insert(has(face.back, part) - has(face.front, part));
    Volume volume{model.parts[p], medium, {}};
    for (const auto& [entry, side] : sides)
      if (side.size() == 1 && *side.begin() != 0) volume.sides.push_back(*side.begin() * (entry + 1));
    if (!volume.sides.empty()) volumes.push_back(volume);
  }
  return volumes;
}

std::vector<std::string> lost_parts(const Options& options, const Model& model, const MeshResult& result) {
  std::vector<std::string> lost;
  std::set<int> edges;  // as read, that have lines
  edges.insert(result.mesh.line_edge.begin(), result.mesh.line_edge.end());
  for (const auto& [line, edge] : result.mesh.further_edges) edges.insert(edge);
  auto is_there = [&](const std::string& name, const PartName& part) {
    if (part.kind == PartKind::edge) return edges.contains(part.index);
    if (part.kind == PartKind::vertex) {
      const Vec3 x = model.read_vertices[part.index];
      for (std::size_t i = 0; i < result.point_names.size(); ++i)
        if (result.point_names[i] == name &&
            norm(result.mesh.nodes[result.mesh.points[i]] - x) <= vertex_reach(model, options))
          return true;
      return false;
    }
    const std::vector<FaceReport>& entries = result.report.faces;  // of the whole mesh, on any rank
    for (std::size_t entry = 0; entry < entries.size(); ++entry)
      if (entries[entry].quads + entries[entry].triangles > 0 && is_of_face(model, static_cast<int>(entry), part.index))
        return true;
    return false;
  };
  auto look = [&](const std::string& name, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
      if (!is_there(name, *parse_part(part))) lost.push_back(fmt::format("{} of '{}'", part, name));
  };
  for (const Port& port : options.ports) look(port.name, port.parts);
  for (const Wire& wire : options.wires) look(wire.name, wire.parts);
  return lost;
}

}  // namespace paver
