// Elements of a mesh one by one.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "check/distance/element_patch.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// An element, or a line of a wire.
struct Piece {
  ElementPatch patch;
  int face = -1, edge = -1;        ///< one of them
  std::array<int, 9> node_edge{};  ///< B-rep edge per node, or -1
  double target = 0;               ///< length, mm

  auto key() const {
    const Vec3 a = patch.nodes[0], b = patch.nodes[1], c = patch.nodes[2];
    return std::tuple(face, edge, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
  }
};

/// What a rank has of a mesh: quads, triangles, then all lines. Targets are at most as long as the longest element: at
/// the lowest frequencies they are beyond that, and all parts were near each other.
class MeshPieces {
 public:
  /// Collective, on the threads of the calling arena. The model's faces and edges are those of the mesh; both are used
  /// as long as this.
  MeshPieces(const SurfaceMesh& mesh, const Model& model, Ranks& ranks);

  std::size_t element_count() const { return quads_ + triangles_; }
  std::size_t count() const { return element_count() + mesh_.line_edge.size(); }
  bool is_of_wire(std::size_t line) const { return model_.edge_part[mesh_.line_edge[line - element_count()]] >= 0; }
  Piece piece(std::size_t i) const;
  /// Of the pieces of all ranks: between corners, mm.
  double longest() const { return longest_; }
  /// Likewise: of a corner, either way.
  double largest_coordinate() const { return largest_coordinate_; }

 private:
  int corners_of(std::size_t i) const { return i < quads_ ? 4 : i < element_count() ? 3 : 2; }
  std::span<const int> nodes_of(std::size_t i) const {
    if (i < quads_) return row(mesh_.quads, mesh_.nodes_per_quad(), i);
    if (i < element_count()) return row(mesh_.triangles, mesh_.nodes_per_triangle(), i - quads_);
    return mesh_.line(i - element_count());
  }
  static std::span<const int> row(const std::vector<int>& rows, int stride, std::size_t i) {
    return {&rows[i * static_cast<std::size_t>(stride)], static_cast<std::size_t>(stride)};
  }

  const SurfaceMesh& mesh_;
  const Model& model_;
  std::size_t quads_, triangles_;
  double longest_ = 0, largest_coordinate_ = 0;
};

}  // namespace paver
