// Results as bytes, from the processes that meshed to the one that asked for it, which puts the shares together.
#include "base/pack_results.h"
#include "paver/output.h"

namespace paver {
namespace {

/// Rows of `width` node indices of a share into the rows of the whole that `rows` tells.
void place_elements(const std::vector<int>& part, std::size_t width, const RowNumbers& rows,
                    const RowNumbers& node_number, std::vector<int>& whole) {
  for (std::size_t i = 0; i < part.size(); ++i)
    whole[static_cast<std::size_t>(rows[i / width]) * width + i % width] = static_cast<int>(node_number[part[i]]);
}

template <class T>
void place(const std::vector<T>& part, const RowNumbers& rows, std::vector<T>& whole) {
  for (std::size_t row = 0; row < part.size(); ++row) whole[rows[row]] = part[row];
}

void resize(const MeshShare& share, SurfaceMesh& whole) {
  auto nodes = static_cast<std::size_t>(share.nodes), quads = static_cast<std::size_t>(share.quads);
  auto triangles = static_cast<std::size_t>(share.triangles);
  whole.order = share.result.mesh.order;
  whole.nodes.resize(nodes);
  if (!share.result.mesh.node_edge.empty()) whole.node_edge.resize(nodes);
  if (!share.result.mesh.node_target.empty()) whole.node_target.resize(nodes);
  whole.quads.resize(quads * static_cast<std::size_t>(whole.nodes_per_quad()));
  whole.quad_face.resize(quads);
  whole.triangles.resize(triangles * static_cast<std::size_t>(whole.nodes_per_triangle()));
  whole.triangle_face.resize(triangles);
}

}  // namespace

std::string pack_result(const MeshResult& result) { return pack(result); }
MeshResult unpack_result(std::string_view bytes) { return unpack<MeshResult>(bytes); }

std::string pack_share(const MeshShare& share) {
  Packer packer;
  packer(static_cast<const ShareNumbers&>(share), share.result);
  return packer.take();
}

MeshShare unpack_share(std::string_view bytes) {
  MeshShare share;
  Unpacker unpacker(bytes);
  unpacker(static_cast<ShareNumbers&>(share), share.result);
  return share;
}

void add_share(const MeshShare& share, MeshResult& whole) {
  const SurfaceMesh& part = share.result.mesh;
  SurfaceMesh& mesh = whole.mesh;
  whole.report = share.result.report;
  whole.face_names = share.result.face_names;
  whole.face_groups = share.result.face_groups;
  whole.volumes = share.result.volumes;
  whole.edge_names = share.result.edge_names;
  whole.edge_groups = share.result.edge_groups;
  whole.point_names = share.result.point_names;
  resize(share, mesh);
  place(part.nodes, share.node_number, mesh.nodes);
  place(part.node_edge, share.node_number, mesh.node_edge);
  place(part.node_target, share.node_number, mesh.node_target);
  place_elements(part.quads, static_cast<std::size_t>(mesh.nodes_per_quad()), share.quad_number, share.node_number,
                 mesh.quads);
  place(part.quad_face, share.quad_number, mesh.quad_face);
  place_elements(part.triangles, static_cast<std::size_t>(mesh.nodes_per_triangle()), share.triangle_number,
                 share.node_number, mesh.triangles);
  place(part.triangle_face, share.triangle_number, mesh.triangle_face);
  auto number_all = [&](const std::vector<int>& nodes) {  // all shares have all of them
    std::vector<int> numbers;
    for (int node : nodes) numbers.push_back(static_cast<int>(share.node_number[node]));
    return numbers;
  };
  mesh.lines = number_all(part.lines);
  mesh.points = number_all(part.points);
  mesh.line_edge = part.line_edge;
  mesh.further_edges = part.further_edges;
}

}  // namespace paver
