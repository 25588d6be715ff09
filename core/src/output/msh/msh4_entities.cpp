// Points, curves and surfaces of a .msh 4.1 file with the boxes about them.
#include "base/box.h"
#include "base/tasks/gather.h"
#include "output/msh/msh_impl.h"

namespace paver {
namespace {

/// Grows the box of each row's entity by the nodes of the row. `entity_of`: 0-based face or edge per row.
void add_boxes(const SurfaceMesh& mesh, const std::vector<int>& table, const std::vector<int>& entity_of,
               std::vector<Box>& boxes) {
  std::size_t stride = entity_of.empty() ? 1 : table.size() / entity_of.size();
  const int* nodes = table.data();
  for (int entity : entity_of) {
    for (std::size_t k = 0; k < stride; ++k) boxes[entity].add(mesh.nodes[nodes[k]]);
    nodes += stride;
  }
}

/// Zeros without sign: which sign a least value of several zeros has would depend on the order of nodes.
Vec3 unsigned_zeros(Vec3 x) { return x + Vec3{0, 0, 0}; }

void write_entity(const Box& box, std::size_t entity, MshNumbers& out) {
  out.integer(static_cast<int>(entity) + 1);
  out.point(unsigned_zeros(box.low)), out.point(unsigned_zeros(box.high));
}

/// A volume of the solid with its signed surfaces, as far as these have elements.
void write_volume(const Volume& volume, std::size_t index, int group, const std::vector<Box>& surfaces,
                  MshNumbers& out) {
  std::vector<int> sides;
  Box box;
  for (int side : volume.sides) {
    const auto face = static_cast<std::size_t>(std::abs(side)) - 1;
    if (face >= surfaces.size() || surfaces[face].is_empty()) continue;
    sides.push_back(side);
    box.add(surfaces[face]);
  }
  write_entity(box, index, out);
  out.count(1), out.integer(group);
  out.count(sides.size());
  for (int side : sides) out.integer(side);
  out.end_line();
}

std::size_t present(const std::vector<Box>& boxes) {
  return static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.end(), [](const Box& box) { return !box.is_empty(); }));
}

}  // namespace

void write_msh4_beginning(const MeshResult& result, const Numbering& numbering, Ranks& ranks, MshNumbers& out) {
  const SurfaceMesh& mesh = result.mesh;
  const std::vector<int>& volume_groups = numbering.groups.of_volume;
  const auto volumes = static_cast<std::size_t>(
      std::count_if(volume_groups.begin(), volume_groups.end(), [](int group) { return group > 0; }));
  std::vector<Box> curves(numbering.lines.size.size()), surfaces(numbering.quads.size.size());
  add_boxes(mesh, mesh.lines, mesh.line_edge, curves);
  add_boxes(mesh, mesh.triangles, mesh.triangle_face, surfaces);
  add_boxes(mesh, mesh.quads, mesh.quad_face, surfaces);
  unite(surfaces, ranks);

  write_msh_beginning("4.1", numbering.groups, out);
  out.sink().write("$Entities\n");
  for (std::size_t count : {mesh.points.size(), present(curves), present(surfaces), volumes}) out.count(count);
  out.end_line();
  for (std::size_t point = 0; point < mesh.points.size(); ++point) {
    out.integer(static_cast<int>(point) + 1);
    out.point(unsigned_zeros(mesh.nodes[mesh.points[point]]));
    out.count(1), out.integer(numbering.groups.of_point[point]);
    out.end_line();
  }
  for (std::size_t edge = 0; edge < curves.size(); ++edge) {
    if (curves[edge].is_empty()) continue;
    write_entity(curves[edge], edge, out);
    const int group = numbering.groups.of_line(static_cast<int>(edge));
    out.count(group > 0);
    if (group > 0) out.integer(group);
    out.count(0);  // end points
    out.end_line();
  }
  for (std::size_t face = 0; face < surfaces.size(); ++face) {
    if (surfaces[face].is_empty()) continue;
    write_entity(surfaces[face], face, out);
    out.count(1), out.integer(numbering.groups.of_face[face]);
    out.count(numbering.face_edges[face].size());
    for (int edge : numbering.face_edges[face]) out.integer(edge + 1);
    out.end_line();
  }
  for (std::size_t v = 0; v < result.volumes.size(); ++v)
    if (volume_groups[v] > 0) write_volume(result.volumes[v], v, volume_groups[v], surfaces, out);
  out.end_section("Entities");
  out.sink().write("$Nodes\n");
}

void write_msh4_head(std::size_t blocks, long total, MshNumbers& out) {
  const auto tags = static_cast<std::size_t>(total);
  for (std::size_t value : {blocks, tags, std::size_t{tags > 0}, tags}) out.count(value);
  out.end_line();
}

}  // namespace paver
