// Curved elements of order 1 to 3: places and tangents by Lagrange polynomials.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace paver::validation {

using Vec = Eigen::Vector3d;

/// Place and tangents at (u, v).
struct ElementPoint {
  Vec x, by_u, by_v;
};

/// Lagrange polynomials of all elements with as many corners and nodes. Quads over [0, 1]², triangles over u, v >= 0,
/// u + v <= 1. Nodes as Gmsh numbers them: corners, sides in turn, then those inside likewise.
class ShapeFunctions {
 public:
  /// Throws std::invalid_argument where no element of order 1 to 3 has so many nodes.
  ShapeFunctions(int corners, int nodes);

  /// One row each for the values, the derivatives by u and by v; one column per node.
  Eigen::MatrixXd at(double u, double v) const;
  int corners() const { return corners_; }

 private:
  int corners_;
  std::vector<Eigen::Vector2i> powers_;
  Eigen::MatrixXd coefficients_;  // of the monomials u^i v^j, a column per node
};

/// An element: its nodes, one column each.
struct CurvedElement {
  const ShapeFunctions* shape;
  Eigen::Matrix3Xd nodes;
  std::vector<long> corner;  ///< numbers of its corners in the mesh

  int corners() const { return shape->corners(); }
  ElementPoint at(double u, double v) const {
    const Eigen::MatrixXd weights = shape->at(u, v);
    const Eigen::Matrix3d found = nodes * weights.transpose();
    return {found.col(0), found.col(1), found.col(2)};
  }
};

/// (u, v) at corner i.
Eigen::Vector2d parameters_of(int corners, int i);

}  // namespace paver::validation
