// Elements of a mesh one by one, as ranks give them to each other, and cells of space to tell which are near others.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <tuple>
#include <vector>

#include "base/box.h"
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

/// Collective: the pieces of all ranks, each once, in an order that does not depend on ranks.
std::vector<Piece> gather_pieces(const std::vector<Piece>& mine, Ranks& ranks);

/// Cubes about a model, those at its border without end: at most `most` along a side, none smaller than the longest
/// element.
class CellGrid {
 public:
  static constexpr int most = 64;

  CellGrid(const Box& whole, double longest);

  /// visit(cell) for the cells that the box meets, 0 <= cell < most^3.
  template <class Visit>
  void visit(const Box& box, Visit visit) const {
    const std::array<int, 3> a = cell(box.low), b = cell(box.high);
    for (int x = a[0]; x <= b[0]; ++x)
      for (int y = a[1]; y <= b[1]; ++y)
        for (int z = a[2]; z <= b[2]; ++z) visit((x * most + y) * most + z);
  }

 private:
  std::array<int, 3> cell(Vec3 x) const {
    auto along = [&](double from) { return std::clamp(static_cast<int>(from / side_), 0, most - 1); };
    const Vec3 from = x - low_;
    return {along(from.x), along(from.y), along(from.z)};
  }

  Vec3 low_;
  double side_ = 1;
};

/// What a rank has of a mesh. Targets are at most as long as the longest element: at the lowest frequencies they are
/// beyond that, and all parts were near each other.
class MeshPieces {
 public:
  /// Collective. The model's faces and edges are those of the mesh; both are used as long as this.
  MeshPieces(const SurfaceMesh& mesh, const Model& model, Ranks& ranks);

  void visit(const std::function<void(const Piece&)>& visit) const;
  /// About the pieces of all ranks.
  CellGrid cells() const { return {whole_, longest_}; }

 private:
  const SurfaceMesh& mesh_;
  const Model& model_;
  Box whole_;
  double longest_ = Box::infinity;  // mm
};

}  // namespace paver
