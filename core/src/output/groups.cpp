// What belongs together in a file: rows of one face or edge, groups by name, edges of faces.
#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "mesh/element_table.h"
#include "output/numbering_impl.h"

namespace paver {
namespace {

constexpr std::size_t longest_name = 127;  // bytes; what readers of .msh files keep

int largest(const std::vector<int>& values) {
  return values.empty() ? -1 : *std::max_element(values.begin(), values.end());
}

/// A name as it may stand between quotes on one line, cut before a broken UTF-8 character.
std::string quotable(std::string name, std::size_t longest = longest_name) {
  std::size_t length = std::min(name.size(), longest);
  while (length < name.size() && length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0) == 0x80) --length;
  name.resize(length);
  for (char& c : name) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return name;
}

std::string name_of_face(const MeshResult& result, std::size_t face) {
  if (face < result.face_groups.size() && !result.face_groups[face].empty()) return result.face_groups[face];
  const std::string name = face < result.face_names.size() ? result.face_names[face] : "";
  return name.empty() ? "Face" + std::to_string(face + 1) : name;
}

/// The groups of one dimension: different names stay different where they are the same when cut.
class Names {
 public:
  Names(std::vector<std::string>& names, std::size_t before) : names_(names), before_(before) {}

  int number(const std::string& name) {
    const auto [at, is_new] = numbers_.emplace(name, static_cast<int>(before_ + names_.size()) + 1);
    if (is_new) names_.push_back(unused(name));
    return at->second;
  }

 private:
  std::string unused(const std::string& name) {
    std::string quoted = quotable(name);
    for (int copy = 2; !used_.insert(quoted).second; ++copy) {
      const std::string tail = " (" + std::to_string(copy) + ")";
      quoted = quotable(name, longest_name - tail.size()) + tail;
    }
    return quoted;
  }

  std::vector<std::string>& names_;
  std::size_t before_;
  std::unordered_map<std::string, int> numbers_;
  std::unordered_set<std::string> used_;
};

long long pair_key(int a, int b) {
  return (static_cast<long long>(std::min(a, b)) << 32) | static_cast<unsigned>(std::max(a, b));
}

/// The B-rep edge of each line, by its two end nodes.
std::unordered_map<long long, int> edge_of_sides(const SurfaceMesh& mesh) {
  std::unordered_map<long long, int> edges;
  edges.reserve(mesh.line_edge.size());
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i)
    edges.emplace(pair_key(mesh.line(i)[0], mesh.line(i)[1]), mesh.line_edge[i]);
  return edges;
}

}  // namespace

Grouping group_rows(const std::vector<int>& group_of, int groups) {
  Grouping result;
  result.start.assign(static_cast<std::size_t>(groups) + 1, 0);
  for (int group : group_of) {
    if (group >= 0) ++result.start[group + 1];
  }
  for (std::size_t i = 1; i < result.start.size(); ++i) result.start[i] += result.start[i - 1];
  result.rows.resize(result.start.back());
  std::vector<std::size_t> next(result.start.begin(), result.start.end() - 1);
  for (std::size_t row = 0; row < group_of.size(); ++row) {
    if (group_of[row] >= 0) result.rows[next[group_of[row]]++] = static_cast<int>(row);
  }
  return result;
}

Groups find_groups(const MeshResult& result, const std::vector<char>& has_elements) {
  Groups groups;
  Names faces(groups.face_names, 0);
  for (std::size_t face = 0; face < has_elements.size(); ++face)
    groups.of_face.push_back(has_elements[face] ? faces.number(name_of_face(result, face)) : 0);
  std::vector<char> has_lines(result.edge_groups.size(), 0);
  for (int edge : result.mesh.line_edge)
    if (edge < static_cast<int>(has_lines.size())) has_lines[edge] = 1;
  Names edges(groups.edge_names, groups.face_names.size());
  for (std::size_t edge = 0; edge < has_lines.size(); ++edge) {
    const std::string& name = result.edge_groups[edge];
    groups.of_edge.push_back(has_lines[edge] && !name.empty() ? edges.number(name) : 0);
  }
  const std::size_t before = groups.face_names.size() + groups.edge_names.size();
  Names points(groups.point_names, before);
  for (std::size_t i = 0; i < result.mesh.points.size(); ++i) {
    const std::string name = i < result.point_names.size() ? result.point_names[i] : "";
    groups.of_point.push_back(points.number(name.empty() ? "Point" + std::to_string(i + 1) : name));
  }
  Names volumes(groups.volume_names, before + groups.point_names.size());
  for (const Volume& volume : result.volumes) {
    bool has_sides = std::any_of(volume.sides.begin(), volume.sides.end(), [&](int side) {
      const auto face = static_cast<std::size_t>(std::abs(side)) - 1;
      return face < has_elements.size() && has_elements[face];
    });
    groups.of_volume.push_back(has_sides ? volumes.number(volume.medium) : 0);
  }
  return groups;
}

int face_count(const MeshResult& result) {
  const SurfaceMesh& mesh = result.mesh;
  return 1 + std::max({largest(mesh.quad_face), largest(mesh.triangle_face),
                       static_cast<int>(result.face_names.size()) - 1});
}

std::vector<int> curve_of_nodes(const SurfaceMesh& mesh, const Grouping& lines) {
  std::vector<int> curve(mesh.nodes.size(), -1);
  std::size_t stride = static_cast<std::size_t>(mesh.order) + 1;
  for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
    int node = mesh.lines[i];
    if (curve[node] >= 0) continue;
    int own = static_cast<std::size_t>(node) < mesh.node_edge.size() ? mesh.node_edge[node] : -1;
    bool has_lines = own >= 0 && own < static_cast<int>(lines.count()) && lines.size(own) > 0;
    curve[node] = has_lines ? own : mesh.line_edge[i / stride];
  }
  return curve;
}

std::vector<std::vector<int>> edges_of_faces(const SurfaceMesh& mesh, const std::vector<int>& curve, int faces) {
  std::vector<std::vector<int>> face_edges(static_cast<std::size_t>(faces));
  auto edges = edge_of_sides(mesh);
  for (const ElementTable& table : {ElementTable(mesh, true), ElementTable(mesh, false)})
    for (std::size_t i = 0; i < table.count(); ++i) {
      const int* element = table.row(i);
      for (int k = 0; k < table.corners; ++k) {
        int a = element[k], b = element[(k + 1) % table.corners];
        if (curve[a] < 0 || curve[b] < 0) continue;
        if (auto found = edges.find(pair_key(a, b)); found != edges.end()) {
          face_edges[table.face[i]].push_back(found->second);
        }
      }
    }
  for (std::vector<int>& list : face_edges) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return face_edges;
}

int gmsh_line_type(int order) { return std::array{1, 8, 26, 27}.at(static_cast<std::size_t>(order) - 1); }
int gmsh_quad_type(int order) { return std::array{3, 10, 36, 37}.at(static_cast<std::size_t>(order) - 1); }
int gmsh_triangle_type(int order) { return std::array{2, 9, 21, 23}.at(static_cast<std::size_t>(order) - 1); }

}  // namespace paver
