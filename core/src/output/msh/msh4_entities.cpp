#include <algorithm>

#include "output/mesh_writers_impl.h"
#include "output/msh/msh4_impl.h"

namespace paver {
namespace {

/// Zeros without sign: which sign a least value of several zeros has would depend on the order of nodes.
Vec3 unsigned_zeros(Vec3 x) { return x + Vec3{0, 0, 0}; }

void write_entity(const Box& box, std::size_t entity, Msh4Numbers& out) {
  out.integer(static_cast<int>(entity) + 1);
  out.point(unsigned_zeros(box.low)), out.point(unsigned_zeros(box.high));
}

std::size_t present(const std::vector<Box>& boxes) {
  return static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.end(), [](const Box& box) { return !box.is_empty(); }));
}

}  // namespace

void add_boxes(const SurfaceMesh& mesh, const std::vector<int>& table, const std::vector<int>& entity_of,
               std::vector<Box>& boxes) {
  std::size_t stride = entity_of.empty() ? 1 : table.size() / entity_of.size();
  const int* nodes = table.data();
  for (int entity : entity_of) {
    for (std::size_t k = 0; k < stride; ++k) boxes[static_cast<std::size_t>(entity)].add(mesh.nodes[nodes[k]]);
    nodes += stride;
  }
}

void write_msh4_beginning(const Msh4Entities& entities, bool is_ascii, ByteSink& sink) {
  Msh4Numbers out(sink, is_ascii);
  write_msh_beginning("4.1", entities.groups, is_ascii, sink);
  sink.write("$Entities\n");
  for (std::size_t count : {std::size_t{0}, present(entities.curves), present(entities.surfaces), std::size_t{0}})
    out.count(count);
  out.end_line();
  for (std::size_t edge = 0; edge < entities.curves.size(); ++edge) {
    if (entities.curves[edge].is_empty()) continue;
    write_entity(entities.curves[edge], edge, out);
    const int group = entities.groups.of_line(static_cast<int>(edge));
    out.count(group > 0);
    if (group > 0) out.integer(group);
    out.count(0);  // end points
    out.end_line();
  }
  for (std::size_t face = 0; face < entities.surfaces.size(); ++face) {
    if (entities.surfaces[face].is_empty()) continue;
    write_entity(entities.surfaces[face], face, out);
    out.count(1), out.integer(entities.groups.of_face[face]);
    out.count(entities.face_edges[face].size());
    for (int edge : entities.face_edges[face]) out.integer(edge + 1);
    out.end_line();
  }
  out.end_section("Entities");
  sink.write("$Nodes\n");
}

void write_msh4_head(std::size_t blocks, std::size_t total, Msh4Numbers& out) {
  for (std::size_t value : {blocks, total, std::size_t{total > 0}, total}) out.count(value);
  out.end_line();
}

}  // namespace paver
