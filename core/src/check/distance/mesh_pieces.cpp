#include "check/distance/mesh_pieces.h"

#include "base/tasks/gather.h"

namespace paver {

std::vector<Piece> gather_pieces(const std::vector<Piece>& mine, Ranks& ranks) {
  std::vector<Piece> pieces = gather_all(mine, ranks);
  std::ranges::sort(pieces, {}, &Piece::key);
  auto is_same = [](const Piece& a, const Piece& b) { return a.key() == b.key(); };
  pieces.erase(std::unique(pieces.begin(), pieces.end(), is_same), pieces.end());
  return pieces;
}

CellGrid::CellGrid(const Box& whole, double longest) : low_(whole.low) {
  const Vec3 size = whole.high - whole.low;
  side_ = std::max(longest, std::max({size.x, size.y, size.z}) / most);
}

MeshPieces::MeshPieces(const SurfaceMesh& mesh, const Model& model, Ranks& ranks) : mesh_(mesh), model_(model) {
  std::vector<Box> whole(1);
  double longest = 0;
  visit([&](const Piece& piece) {
    const Vec3* x = piece.patch.nodes.data();
    for (int k = 0; k < piece.patch.corners; ++k) {
      whole[0].add(x[k]);
      longest = std::max(longest, norm(x[k] - x[0]));
    }
  });
  unite(whole, ranks);
  whole_ = whole[0];
  longest_ = greatest(longest, ranks);
}

void MeshPieces::visit(const std::function<void(const Piece&)>& visit) const {
  auto all = [&](const std::vector<int>& rows, const std::vector<int>& owners, int corners, int stride) {
    for (std::size_t i = 0; i < owners.size(); ++i) {
      if (corners == 2 && model_.edge_part[owners[i]] < 0) continue;
      Piece piece;
      piece.patch.corners = corners;
      piece.patch.order = mesh_.order;
      (corners > 2 ? piece.face : piece.edge) = owners[i];
      for (int k = 0; k < stride; ++k) {
        piece.patch.nodes[k] = mesh_.nodes[rows[i * stride + k]];
        piece.node_edge[k] = mesh_.node_edge[rows[i * stride + k]];
      }
      for (int k = 0; k < corners; ++k) piece.target += mesh_.node_target[rows[i * stride + k]] / corners;
      piece.target = std::min(piece.target, longest_);
      visit(piece);
    }
  };
  all(mesh_.quads, mesh_.quad_face, 4, mesh_.nodes_per_quad());
  all(mesh_.triangles, mesh_.triangle_face, 3, mesh_.nodes_per_triangle());
  all(mesh_.lines, mesh_.line_edge, 2, mesh_.order + 1);
}

}  // namespace paver
