// Gmsh .msh 2.2, ASCII and binary. Elements in the order points, lines, triangles, quads, each with two tags: physical
// group and entity.
#include <fmt/format.h>

#include <iterator>

#include "output/mesh_writers_impl.h"
#include "output/numbering_impl.h"

namespace paver {
namespace {

constexpr int tags_per_element = 2;

/// One kind of element with its tags.
struct Table {
  int type, stride;
  const std::vector<int>& nodes;
  const std::vector<int>& entity_of;  ///< 0-based face or edge
  const std::vector<int>& group_of;   ///< per entity; entities beyond its end are in no group

  int group(std::size_t row) const {
    const auto entity = static_cast<std::size_t>(entity_of[row]);
    return entity < group_of.size() ? group_of[entity] : 0;
  }
};

void write_nodes(const SurfaceMesh& mesh, const Numbering& numbering, bool is_ascii, AtomicFile& file) {
  file.write(fmt::format("$Nodes\n{}\n", numbering.tags.count));
  fmt::memory_buffer text;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const int tag = static_cast<int>(numbering.tags.of_node[i]);
    if (tag == 0) continue;
    Vec3 x = mesh.nodes[i];
    if (is_ascii) {
      text.clear();
      fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", tag, x.x, x.y, x.z);
      file.write(text.data(), text.size());
    } else {
      file.write_packed(tag);
      file.write_packed(x);
    }
  }
  file.write(is_ascii ? "$EndNodes\n" : "\n$EndNodes\n");
}

void write_table(const Table& table, const Numbering& numbering, bool is_ascii, int& number, AtomicFile& file) {
  std::size_t rows = table.entity_of.size();
  if (rows == 0) return;
  if (!is_ascii) {
    for (int head : {table.type, static_cast<int>(rows), tags_per_element}) file.write_packed(head);
  }
  fmt::memory_buffer text;
  const std::vector<long>& tag = numbering.tags.of_node;
  for (std::size_t row = 0; row < rows; ++row) {
    int group = table.group(row), entity = table.entity_of[row] + 1;
    const int* nodes = table.nodes.data() + row * table.stride;
    ++number;
    if (!is_ascii) {
      for (int value : {number, group, entity}) file.write_packed(value);
      for (int k = 0; k < table.stride; ++k) file.write_packed(static_cast<int>(tag[nodes[k]]));
      continue;
    }
    text.clear();
    fmt::format_to(std::back_inserter(text), "{} {} {} {} {}", number, table.type, tags_per_element, group, entity);
    for (int k = 0; k < table.stride; ++k) {
      fmt::format_to(std::back_inserter(text), " {}", tag[nodes[k]]);
    }
    text.push_back('\n');
    file.write(text.data(), text.size());
  }
}

class Msh2Writer : public MeshWriter {
 public:
  Msh2Writer(HeldMesh held, bool is_ascii, Ranks& ranks)
      : mesh_(held.result.mesh), is_ascii_(is_ascii), numbering_(held, ranks) {}

  void write(AtomicFile& file) const override {
    write_msh_beginning("2.2", numbering_.groups, is_ascii_, file);
    write_nodes(mesh_, numbering_, is_ascii_, file);
    file.write(fmt::format("$Elements\n{}\n", numbering_.points.total() + mesh_.line_edge.size() +
                                                  mesh_.triangle_count() + mesh_.quad_count()));
    const int p = mesh_.order;
    const std::vector<int>& groups = numbering_.groups.of_face;
    int number = 0;
    for (const Table& table :
         {Table{gmsh_point_type, 1, mesh_.points, numbering_.points.held.rows, numbering_.groups.of_point},
          Table{gmsh_line_type(p), p + 1, mesh_.lines, mesh_.line_edge, numbering_.groups.of_edge},
          Table{gmsh_triangle_type(p), mesh_.nodes_per_triangle(), mesh_.triangles, mesh_.triangle_face, groups},
          Table{gmsh_quad_type(p), mesh_.nodes_per_quad(), mesh_.quads, mesh_.quad_face, groups}})
      write_table(table, numbering_, is_ascii_, number, file);
    file.write(is_ascii_ ? "$EndElements\n" : "\n$EndElements\n");
  }

 private:
  const SurfaceMesh& mesh_;
  const bool is_ascii_;
  const Numbering numbering_;
};

}  // namespace

void write_msh_beginning(const char* version, const Groups& groups, bool is_ascii, ByteSink& sink) {
  sink.write(fmt::format("$MeshFormat\n{} {} 8\n", version, is_ascii ? 0 : 1));
  if (!is_ascii) {
    sink.write_packed(1);  // readers learn the byte order from it
    sink.write("\n");
  }
  sink.write("$EndMeshFormat\n");
  const std::pair<int, const std::vector<std::string>&> names_by_dimension[] = {
      {2, groups.face_names}, {1, groups.edge_names}, {0, groups.point_names}, {3, groups.volume_names}};
  std::size_t count = 0;
  for (const auto& [dimension, names] : names_by_dimension) count += names.size();
  if (count == 0) return;
  sink.write(fmt::format("$PhysicalNames\n{}\n", count));
  int number = 0;
  for (const auto& [dimension, names] : names_by_dimension)
    for (const std::string& name : names) sink.write(fmt::format("{} {} \"{}\"\n", dimension, ++number, name));
  sink.write("$EndPhysicalNames\n");
}

std::unique_ptr<MeshWriter> msh2_writer(HeldMesh held, bool is_ascii, Ranks& ranks) {
  return std::make_unique<Msh2Writer>(held, is_ascii, ranks);
}

}  // namespace paver
