// In: model, reports of faces. Out: parts by component. Faces, wires and points that share a vertex share its node.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/union_find.h"
#include "entries/parts.h"

namespace paver {
namespace {

class Components {
 public:
  Components(const Model& model, const std::vector<FaceReport>& entries)
      : model_(model), entries_(entries), together_(model.vertices.size() + model.faces.size() + model.edges.size()) {}

  std::vector<std::vector<std::string>> run() {
    std::vector<std::pair<int, int>> items;  // with a part of each
    for (std::size_t f = 0; f < model_.faces.size(); ++f) {
      if (!is_meshed(f)) continue;
      add_face(f);
      for (int part : model_.face_parts[f]) items.emplace_back(face_item(f), part);
    }
    for (std::size_t e = 0; e < model_.edges.size(); ++e) {
      if (!has_lines_of_wire(e)) continue;
      add_ends(model_.edges[e], edge_item(e));
      items.emplace_back(edge_item(e), model_.edge_part[e]);
    }
    std::map<int, std::vector<char>> parts;  // per component: whether it has each part
    auto note = [&](int item, int part) {
      std::vector<char>& has = parts[together_.find(item)];
      has.resize(model_.parts.size(), 0);
      has[part] = 1;
    };
    for (const auto& [item, part] : items) note(item, part);
    for (const PartPoint& point : model_.points)
      if (point.part >= 0 && parts.contains(together_.find(vertex_item(point.vertex))))
        note(vertex_item(point.vertex), point.part);
    std::vector<std::vector<std::string>> components;
    for (const auto& [root, has] : parts) {
      std::vector<std::string>& names = components.emplace_back();
      for (std::size_t p = 0; p < has.size(); ++p)
        if (has[p]) names.push_back(model_.parts[p]);
    }
    return components;
  }

 private:
  bool is_meshed(std::size_t f) const {
    const Face& face = model_.faces[f];
    return face.has_area && entries_[face.origin].status == FaceStatus::meshed;
  }
  bool has_lines_of_wire(std::size_t e) const {
    const std::vector<int>& faces = model_.edges[e].faces;
    auto has_mesh = [&](int face) { return is_meshed(static_cast<std::size_t>(face)); };
    return is_of_wire(model_, static_cast<int>(e)) &&
           (faces.empty() || std::any_of(faces.begin(), faces.end(), has_mesh));
  }
  // Faces and wires come first, in the order of the model, so that the least item of a component tells its place.
  int face_item(std::size_t f) const { return static_cast<int>(f); }
  int edge_item(std::size_t e) const { return static_cast<int>(model_.faces.size() + e); }
  int vertex_item(int v) const { return static_cast<int>(model_.faces.size() + model_.edges.size()) + v; }

  void add_face(std::size_t f) {
    for (const Coedge& c : coedges_of(model_.faces[f].loops)) add_ends(edge_of(model_, c), face_item(f));
    for (const InnerPoint& point : model_.faces[f].points) together_.merge(vertex_item(point.vertex), face_item(f));
  }

  void add_ends(const Edge& edge, int item) {
    together_.merge(vertex_item(edge.start), item);
    together_.merge(vertex_item(edge.end), item);
  }

  const Model& model_;
  const std::vector<FaceReport>& entries_;
  UnionFind together_;
};

}  // namespace

std::vector<std::vector<std::string>> find_components(const Model& model, const std::vector<FaceReport>& entries) {
  return Components(model, entries).run();
}

std::vector<std::array<std::string, 2>> contacts_apart(const std::vector<Contact>& contacts,
                                                       const std::vector<std::vector<std::string>>& components) {
  std::map<std::string, std::set<std::size_t>> sets_of;
  for (std::size_t i = 0; i < components.size(); ++i)
    for (const std::string& part : components[i]) sets_of[part].insert(i);
  std::vector<std::array<std::string, 2>> apart;
  for (const Contact& contact : contacts) {
    const std::set<std::size_t>&one = sets_of[contact.parts[0]], &two = sets_of[contact.parts[1]];
    if (one.empty() || two.empty() || std::ranges::find_first_of(one, two) != one.end()) continue;
    if (std::ranges::find(apart, contact.parts) == apart.end()) apart.push_back(contact.parts);
  }
  return apart;
}

}  // namespace paver
