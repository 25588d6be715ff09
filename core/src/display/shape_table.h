// Lagrange shape functions of an element at the points of a lattice.
#pragma once

#include <vector>

#include "quality/jacobian/jacobian.h"

namespace paver {

/// The points (i / n, j / n) of the reference quad, or those of them with i + j <= n of the triangle, row by row in i;
/// and how they follow from the element's nodes in Gmsh's order.
class ShapeTable {
 public:
  ShapeTable(ElementShape shape, int order, int n);

  int point_count() const { return points_; }
  int node_count() const { return nodes_; }
  /// Which point (i, j) is.
  int index(int i, int j) const;

  /// Position of a point from the element's nodes `x`.
  Vec3 position(const Vec3* x, int point) const;
  /// x_u cross x_v at a point.
  Vec3 normal(const Vec3* x, int point) const;

 private:
  ElementShape shape_;
  int n_, nodes_, points_;
  std::vector<double> value_, du_, dv_;  ///< point_count() x node_count()
};

}  // namespace paver
