// Gmsh .msh 4.1, ASCII and binary. Sections: format, physical names, entities (curves and surfaces, no points),
// nodes by entity, elements by entity and kind. In binary all counts and tags of nodes and elements are 64-bit.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>

#include "output/mesh_writers_impl.h"
#include "output/numbering_impl.h"

namespace paver {
namespace {

/// Numbers of a section as text with blanks between them, or packed.
class Numbers {
 public:
  Numbers(AtomicFile& file, bool is_ascii) : file_(file), is_ascii_(is_ascii) {}

  void count(std::size_t value) { is_ascii_ ? text(value) : file_.write_packed<std::uint64_t>(value); }
  void integer(int value) { is_ascii_ ? text(value) : file_.write_packed(value); }
  void real(double value) { is_ascii_ ? text(value) : file_.write_packed(value); }
  void point(Vec3 x) { real(x.x), real(x.y), real(x.z); }

  /// Ends a line of text; nothing in binary.
  void end_line() {
    if (!is_ascii_) return;
    line_.push_back('\n');
    file_.write(line_.data(), line_.size());
    line_.clear();
  }
  void end_section(const char* name) { file_.write(fmt::format("{}$End{}\n", is_ascii_ ? "" : "\n", name)); }

 private:
  template <class T>
  void text(T value) {
    if (line_.size()) line_.push_back(' ');
    fmt::format_to(std::back_inserter(line_), "{}", value);
  }

  AtomicFile& file_;
  bool is_ascii_;
  fmt::memory_buffer line_;
};

/// One kind of element, dealt by face or edge.
struct Table {
  int dimension, type, stride;
  const std::vector<int>& nodes;
  const Grouping& by_entity;
};

struct Box {
  Vec3 low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void add(Vec3 x) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
};

void extend(Box& box, const SurfaceMesh& mesh, const Table& table, std::size_t entity) {
  for (std::size_t i = table.by_entity.start[entity]; i < table.by_entity.start[entity + 1]; ++i) {
    std::size_t first = static_cast<std::size_t>(table.by_entity.rows[i]) * table.stride;
    for (int k = 0; k < table.stride; ++k) box.add(mesh.nodes[table.nodes[first + k]]);
  }
}

std::size_t used_groups(const Grouping& grouping) {
  std::size_t used = 0;
  for (std::size_t g = 0; g < grouping.count(); ++g) used += grouping.size(g) > 0;
  return used;
}

void write_entities(const SurfaceMesh& mesh, const Numbering& numbering, const Table& lines, const Table& triangles,
                    const Table& quads, Numbers& out) {
  std::size_t faces = 0;
  for (std::size_t f = 0; f < numbering.quads.count(); ++f) faces += numbering.has_elements(f);
  for (std::size_t count : {std::size_t{0}, used_groups(numbering.lines), faces, std::size_t{0}}) out.count(count);
  out.end_line();
  for (std::size_t edge = 0; edge < numbering.lines.count(); ++edge) {
    if (numbering.lines.size(edge) == 0) continue;
    Box box;
    extend(box, mesh, lines, edge);
    out.integer(static_cast<int>(edge) + 1);
    out.point(box.low), out.point(box.high);
    out.count(0), out.count(0);  // physical groups, end points
    out.end_line();
  }
  for (std::size_t face = 0; face < numbering.quads.count(); ++face) {
    if (!numbering.has_elements(face)) continue;
    Box box;
    extend(box, mesh, triangles, face), extend(box, mesh, quads, face);
    out.integer(static_cast<int>(face) + 1);
    out.point(box.low), out.point(box.high);
    out.count(1), out.integer(numbering.face_group[face]);
    out.count(numbering.face_edges[face].size());
    for (int edge : numbering.face_edges[face]) out.integer(edge + 1);
    out.end_line();
  }
}

void write_node_blocks(const SurfaceMesh& mesh, const Numbering& numbering, int dimension, const Grouping& nodes,
                       Numbers& out) {
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

void write_element_blocks(const Numbering& numbering, const Table& table, std::size_t& number, Numbers& out) {
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

/// Blocks, total, lowest and highest tag: how the sections for nodes and elements begin.
void write_head(std::size_t blocks, std::size_t total, Numbers& out) {
  for (std::size_t value : {blocks, total, std::size_t{total > 0}, total}) out.count(value);
  out.end_line();
}

}  // namespace

void write_msh4(const MeshResult& result, bool is_ascii, AtomicFile& file) {
  const SurfaceMesh& mesh = result.mesh;
  int p = mesh.order;
  Numbering numbering(result);
  Table lines{1, gmsh_line_type(p), p + 1, mesh.lines, numbering.lines};
  Table triangles{2, gmsh_triangle_type(p), mesh.nodes_per_triangle(), mesh.triangles, numbering.triangles};
  Table quads{2, gmsh_quad_type(p), mesh.nodes_per_quad(), mesh.quads, numbering.quads};
  Numbers out(file, is_ascii);

  file.write(fmt::format("$MeshFormat\n4.1 {} 8\n", is_ascii ? 0 : 1));
  if (!is_ascii) {
    file.write_packed(1);  // readers learn the byte order from it
    file.write("\n");
  }
  file.write("$EndMeshFormat\n");
  write_physical_names(numbering, file);
  file.write("$Entities\n");
  write_entities(mesh, numbering, lines, triangles, quads, out);
  out.end_section("Entities");
  file.write("$Nodes\n");
  write_head(used_groups(numbering.curve_nodes) + used_groups(numbering.surface_nodes),
             static_cast<std::size_t>(numbering.node_count), out);
  write_node_blocks(mesh, numbering, 1, numbering.curve_nodes, out);
  write_node_blocks(mesh, numbering, 2, numbering.surface_nodes, out);
  out.end_section("Nodes");
  file.write("$Elements\n");
  write_head(used_groups(numbering.lines) + used_groups(numbering.triangles) + used_groups(numbering.quads),
             numbering.lines.rows.size() + numbering.triangles.rows.size() + numbering.quads.rows.size(), out);
  std::size_t number = 0;
  for (const Table* table : {&lines, &triangles, &quads}) write_element_blocks(numbering, *table, number, out);
  out.end_section("Elements");
}

}  // namespace paver
