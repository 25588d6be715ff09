// An element or line as the polynomial that its nodes state.
#pragma once

#include <array>

#include "base/box.h"
#include "paver/vec.h"

namespace paver {

/// A line (one corner more than ends), triangle or quad of order 1 or 2 with its nodes in Gmsh's order. Parameters run
/// from 0 to 1, on a triangle up to u + v = 1, on a line v is 0.
struct ElementPatch {
  int corners = 4;  ///< 2, 3, 4
  int order = 2;
  std::array<Vec3, 9> nodes{};

  int node_count() const;
  Vec2 node_place(int k) const;
  Vec3 at(Vec2 uv) const;
  /// Of the derivatives by u and v.
  std::array<Vec3, 2> slopes(Vec2 uv) const;
  /// Holds all of the patch: of its nodes as a Bezier patch has them.
  Box bounds() const;
  /// Of the diagonals, of any length; of a line none.
  Vec3 mean_normal() const;
  /// Where the patch is nearest to x, from a place that is near it: Gauss-Newton with steps halved until they help.
  Vec2 nearest(Vec3 x, Vec2 start) const;
};

/// A pair of points of two patches, as near to each other as going back and forth between the patches gets from their
/// nearest nodes.
struct PatchDistance {
  double distance = 0;
  Vec3 where;  ///< on the first
  Vec3 way;    ///< from there to the second
};
PatchDistance distance(const ElementPatch& a, const ElementPatch& b);

/// Whether a plane is seen to part two patches by more than `near`: along one of them or upright on one of its sides,
/// or across the way between them.
bool are_apart(const ElementPatch& a, const ElementPatch& b, double near);

}  // namespace paver
