#include "check/near/mesh_pieces.h"

#include <algorithm>
#include <cmath>

#include "base/tasks/gather.h"

namespace paver {

MeshPieces::MeshPieces(const SurfaceMesh& mesh, const Model& model, Ranks& ranks)
    : mesh_(mesh), model_(model), quads_(mesh.quad_count()), triangles_(mesh.triangle_count()) {
  double longest = 0, largest = 0;
  auto measure = [&](auto nodes, int corners) {
    const Vec3 first = mesh.nodes[nodes[0]];
    largest = std::max({largest, std::abs(first.x), std::abs(first.y), std::abs(first.z)});
    for (int k = 1; k < corners; ++k) longest = std::max(longest, norm(mesh.nodes[nodes[k]] - first));
  };
  for (std::size_t i = 0; i < quads_; ++i) measure(quad(i), 4);
  for (std::size_t i = 0; i < triangles_; ++i) measure(triangle(i), 3);
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i)
    if (is_of_wire(element_count() + i)) measure(mesh.line(i), 2);
  longest_ = greatest(longest, ranks);
  largest_coordinate_ = greatest(largest, ranks) + longest_;
}

Piece MeshPieces::piece(std::size_t i) const {
  Piece piece;
  piece.patch.order = mesh_.order;
  auto fill = [&](auto nodes, int corners) {
    piece.patch.corners = corners;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      piece.patch.nodes[k] = mesh_.nodes[nodes[k]];
      piece.node_edge[k] = mesh_.node_edge[nodes[k]];
    }
    for (int k = 0; k < corners; ++k) piece.target += mesh_.node_target[nodes[k]] / corners;
    piece.target = std::min(piece.target, longest_);
  };
  if (i < quads_) {
    piece.face = mesh_.quad_face[i];
    fill(quad(i), 4);
  } else if (i < element_count()) {
    piece.face = mesh_.triangle_face[i - quads_];
    fill(triangle(i - quads_), 3);
  } else {
    piece.edge = mesh_.line_edge[i - element_count()];
    fill(mesh_.line(i - element_count()), 2);
  }
  return piece;
}

}  // namespace paver
