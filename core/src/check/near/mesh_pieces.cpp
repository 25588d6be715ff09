#include "check/near/mesh_pieces.h"

#include <algorithm>
#include <cmath>

#include "base/tasks/gather.h"
#include "base/tasks/tasks.h"

namespace paver {

MeshPieces::MeshPieces(const SurfaceMesh& mesh, const Model& model, Ranks& ranks)
    : mesh_(mesh), model_(model), quads_(mesh.quad_count()), triangles_(mesh.triangle_count()) {
  constexpr std::size_t stretch = 1 << 16;
  std::vector<std::array<double, 2>> most(count() / stretch + 1);  // lengths and coordinates
  run_stretches(count(), stretch, [&](std::size_t begin, std::size_t end) {
    double longest = 0, largest = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (i >= element_count() && !is_of_wire(i)) continue;
      const std::span<const int> nodes = nodes_of(i);
      const Vec3 first = mesh.nodes[nodes[0]];
      largest = std::max({largest, std::abs(first.x), std::abs(first.y), std::abs(first.z)});
      for (int k = 1; k < corners_of(i); ++k) longest = std::max(longest, norm(mesh.nodes[nodes[k]] - first));
    }
    most[begin / stretch] = {longest, largest};
  });
  for (const auto& [longest, largest] : most) {
    longest_ = std::max(longest_, longest);
    largest_coordinate_ = std::max(largest_coordinate_, largest);
  }
  longest_ = greatest(longest_, ranks);
  largest_coordinate_ = greatest(largest_coordinate_, ranks) + longest_;
}

Piece MeshPieces::piece(std::size_t i) const {
  Piece piece;
  piece.patch.order = mesh_.order;
  piece.patch.corners = corners_of(i);
  const std::span<const int> nodes = nodes_of(i);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    piece.patch.nodes[k] = mesh_.nodes[nodes[k]];
    piece.node_edge[k] = mesh_.node_edge[nodes[k]];
  }
  for (int k = 0; k < piece.patch.corners; ++k) piece.target += mesh_.node_target[nodes[k]] / piece.patch.corners;
  piece.target = std::min(piece.target, longest_);
  if (i < quads_) {
    piece.face = mesh_.quad_face[i];
  } else if (i < element_count()) {
    piece.face = mesh_.triangle_face[i - quads_];
  } else {
    piece.edge = mesh_.line_edge[i - element_count()];
  }
  return piece;
}

}  // namespace paver
