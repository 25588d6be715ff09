// By numbers of the shape as read: edges of the model know their origins, faces their entry of the report, vertices are
// found by their place, as what connects parts may have moved one onto another.
#include "topology/named_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/local_parts.h"
#include "paver/error.h"

namespace paver {
namespace {

std::size_t count_of(const Model& model, PartKind kind) {
  switch (kind) {
    case PartKind::face:
      return static_cast<std::size_t>(model.read_faces);
    case PartKind::edge:
      return static_cast<std::size_t>(model.read_edges);
    case PartKind::vertex:
      return model.read_vertices.size();
    case PartKind::solid:
      break;
  }
  return model.solid_faces.size();
}

const char* kind_of(PartKind kind) {
  constexpr const char* names[] = {"Face", "Edge", "Vertex", "Solid"};
  return names[static_cast<std::size_t>(kind)];
}

/// The nearest one that an edge ends at, no farther than `most`; -1: none.
int nearest_vertex(const Model& model, Vec3 x, double most) {
  int nearest = -1;
  auto visit = [&](int vertex) {
    const double distance = norm(model.vertices[vertex] - x);
    if (distance <= most) nearest = vertex, most = distance;
  };
  for (const Edge& edge : model.edges) visit(edge.start), visit(edge.end);
  return nearest;
}

void put_group(Model& model, const std::string& name, const std::vector<std::string>& parts, double most) {
  for (const std::string& text : parts) {
    check_part(model, text, fmt::format("'{}'", name));
    const PartName part = *parse_part(text);
    const auto index = static_cast<std::size_t>(part.index);
    if (part.kind == PartKind::edge) model.edge_group[index] = name;
    if (part.kind == PartKind::face)
      for (std::size_t entry = 0; entry < model.face_group.size(); ++entry)
        if (is_of_face(model, static_cast<int>(entry), part.index)) model.face_group[entry] = name;
    if (part.kind == PartKind::vertex)
      if (const int vertex = nearest_vertex(model, model.read_vertices[index], most); vertex >= 0)
        model.points.push_back({-1, vertex, false, name});
  }
}

}  // namespace

void check_part(const Model& model, const std::string& part, const std::string& who) {
  const PartName name = *parse_part(part);
  const std::size_t count = count_of(model, name.kind);
  if (static_cast<std::size_t>(name.index) < count) return;
  const std::string kind = kind_of(name.kind);
  const std::string has = count == 0   ? "no " + kind + "; name another part"
                          : count == 1 ? "only " + kind + "1; name that"
                                       : fmt::format("{0}1 to {0}{1}; name one of these", kind, count);
  throw Error(ErrorCode::bad_option, fmt::format("{} names {}, but the model has {}.", who, part, has));
}

double vertex_reach(const Model& model, const Options& options) {
  constexpr double same_place = 0.01;  // of the target length
  return model.report.sew_tolerance + same_place * target_length(options);
}

bool is_of_face(const Model& model, int entry, int face) {
  const auto& faces = model.faces_as_read(entry);
  return std::find(faces.begin(), faces.end(), face) != faces.end();
}

void name_parts(Model& model, const Options& options) {
  model.face_group.assign(static_cast<std::size_t>(model.read_faces) + model.common.size(), "");
  model.edge_group.assign(static_cast<std::size_t>(model.read_edges), "");
  model.solid_medium.assign(model.solid_faces.size(), "");
  const double most = vertex_reach(model, options);
  for (const Port& port : options.ports) put_group(model, port.name, port.parts, most);
  for (const Wire& wire : options.wires) put_group(model, wire.name, wire.parts, most);
  std::set<int> local;
  for (const LocalSize& size : options.local) {
    check_part(model, size.part, "local");
    if (const PartName part = *parse_part(size.part); part.kind == PartKind::vertex)
      local.insert(nearest_vertex(model, model.read_vertices[part.index], most));
  }
  add_periodic_points(model, local);
  for (const Medium& medium : options.media)
    for (const std::string& part : medium.parts) {
      check_part(model, part, fmt::format("medium '{}'", medium.name));
      model.solid_medium[parse_part(part)->index] = medium.name;
    }
}

std::string medium_of(const Model& model, const std::vector<int>& parts) {
  for (int part : parts) {
    const int solid = model.part_solid[part];
    if (solid >= 0 && !model.solid_medium[solid].empty()) return model.solid_medium[solid];
  }
  return "";
}

}  // namespace paver
