// Gmsh .msh 4.1, ASCII and binary. Sections: format, physical names, entities (curves and surfaces, no points),
// nodes by entity, elements by entity and kind. In binary all counts and tags of nodes and elements are 64-bit.
#include "output/atomic_file_impl.h"
#include "output/mesh_writers_impl.h"
#include "output/msh/msh4_impl.h"

namespace paver {
namespace {

/// One kind of element, dealt by face or edge.
struct Table {
  int dimension, type, stride;
  const std::vector<int>& nodes;
  const Grouping& by_entity;
};

std::size_t used_groups(const Grouping& grouping) {
  std::size_t used = 0;
  for (std::size_t g = 0; g < grouping.count(); ++g) used += grouping.size(g) > 0;
  return used;
}

void write_node_blocks(const SurfaceMesh& mesh, const Numbering& numbering, int dimension, const Grouping& nodes,
                       Msh4Numbers& out) {
  for (std::size_t entity = 0; entity < nodes.count(); ++entity) {
    if (nodes.size(entity) == 0) continue;
    out.integer(dimension), out.integer(static_cast<int>(entity) + 1), out.integer(0), out.count(nodes.size(entity));
    out.end_line();
    for (std::size_t i = nodes.start[entity]; i < nodes.start[entity + 1]; ++i) {
      out.count(static_cast<std::size_t>(numbering.node_tag[nodes.rows[i]]));
      out.end_line();
    }
    for (std::size_t i = nodes.start[entity]; i < nodes.start[entity + 1]; ++i) {
      out.point(mesh.nodes[nodes.rows[i]]);
      out.end_line();
    }
  }
}

void write_element_blocks(const Numbering& numbering, const Table& table, std::size_t& number, Msh4Numbers& out) {
  const Grouping& rows = table.by_entity;
  for (std::size_t entity = 0; entity < rows.count(); ++entity) {
    if (rows.size(entity) == 0) continue;
    out.integer(table.dimension), out.integer(static_cast<int>(entity) + 1), out.integer(table.type);
    out.count(rows.size(entity));
    out.end_line();
    for (std::size_t i = rows.start[entity]; i < rows.start[entity + 1]; ++i) {
      out.count(++number);
      const int* nodes = table.nodes.data() + static_cast<std::size_t>(rows.rows[i]) * table.stride;
      for (int k = 0; k < table.stride; ++k) out.count(static_cast<std::size_t>(numbering.node_tag[nodes[k]]));
      out.end_line();
    }
  }
}

Msh4Entities entities_of(const SurfaceMesh& mesh, const Numbering& numbering) {
  Msh4Entities entities{std::vector<Box>(numbering.lines.count()), std::vector<Box>(numbering.quads.count()),
                        numbering.groups, numbering.face_edges};
  add_boxes(mesh, mesh.lines, mesh.line_edge, entities.curves);
  add_boxes(mesh, mesh.triangles, mesh.triangle_face, entities.surfaces);
  add_boxes(mesh, mesh.quads, mesh.quad_face, entities.surfaces);
  return entities;
}

}  // namespace

void write_msh4(const MeshResult& result, bool is_ascii, AtomicFile& file) {
  const SurfaceMesh& mesh = result.mesh;
  int p = mesh.order;
  Numbering numbering(result);
  Table lines{1, gmsh_line_type(p), p + 1, mesh.lines, numbering.lines};
  Table triangles{2, gmsh_triangle_type(p), mesh.nodes_per_triangle(), mesh.triangles, numbering.triangles};
  Table quads{2, gmsh_quad_type(p), mesh.nodes_per_quad(), mesh.quads, numbering.quads};
  Msh4Numbers out(file, is_ascii);

  write_msh4_beginning(entities_of(mesh, numbering), is_ascii, file);
  write_msh4_head(used_groups(numbering.curve_nodes) + used_groups(numbering.surface_nodes),
                  static_cast<std::size_t>(numbering.node_count), out);
  write_node_blocks(mesh, numbering, 1, numbering.curve_nodes, out);
  write_node_blocks(mesh, numbering, 2, numbering.surface_nodes, out);
  out.end_section("Nodes");
  file.write("$Elements\n");
  write_msh4_head(used_groups(numbering.lines) + used_groups(numbering.triangles) + used_groups(numbering.quads),
                  numbering.lines.rows.size() + numbering.triangles.rows.size() + numbering.quads.rows.size(), out);
  std::size_t number = 0;
  for (const Table* table : {&lines, &triangles, &quads}) write_element_blocks(numbering, *table, number, out);
  out.end_section("Elements");
}

}  // namespace paver
