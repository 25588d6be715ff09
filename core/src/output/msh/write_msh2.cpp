// Gmsh .msh 2.2, ASCII and binary. Elements in the order points, lines, triangles, quads, each with two tags: physical
// group and entity.
#include "output/mesh_writers_impl.h"
#include "output/msh/msh_impl.h"

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

void write_nodes(const SurfaceMesh& mesh, const Numbering& numbering, MshNumbers& out) {
  out.sink().write(fmt::format("$Nodes\n{}\n", numbering.tags.count));
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const int tag = static_cast<int>(numbering.tags.of_node[i]);
    if (tag == 0) continue;
    out.integer(tag), out.point(mesh.nodes[i]);
    out.end_line();
  }
  out.end_section("Nodes");
}

/// In text each element says its type, in binary all of a type together do.
void write_table(const Table& table, const Numbering& numbering, int& number, MshNumbers& out) {
  const std::size_t rows = table.entity_of.size();
  if (rows == 0) return;
  if (!out.is_ascii())
    for (int head : {table.type, static_cast<int>(rows), tags_per_element}) out.integer(head);
  for (std::size_t row = 0; row < rows; ++row) {
    out.integer(++number);
    if (out.is_ascii()) out.integer(table.type), out.integer(tags_per_element);
    out.integer(table.group(row)), out.integer(table.entity_of[row] + 1);
    const int* nodes = table.nodes.data() + row * table.stride;
    for (int k = 0; k < table.stride; ++k) out.integer(static_cast<int>(numbering.tags.of_node[nodes[k]]));
    out.end_line();
  }
}

class Msh2Writer : public MeshWriter {
 public:
  Msh2Writer(HeldMesh held, bool is_ascii, Ranks& ranks)
      : mesh_(held.result.mesh), is_ascii_(is_ascii), numbering_(held, ranks) {}

  void write(AtomicFile& file) const override {
    MshNumbers out(file, is_ascii_);
    write_msh_beginning("2.2", numbering_.groups, out);
    write_nodes(mesh_, numbering_, out);
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
      write_table(table, numbering_, number, out);
    out.end_section("Elements");
  }

 private:
  const SurfaceMesh& mesh_;
  const bool is_ascii_;
  const Numbering numbering_;
};

}  // namespace

void write_msh_beginning(const char* version, const Groups& groups, MshNumbers& out) {
  ByteSink& sink = out.sink();
  sink.write(fmt::format("$MeshFormat\n{} {} 8\n", version, out.is_ascii() ? 0 : 1));
  if (!out.is_ascii()) {
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
