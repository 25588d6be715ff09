// A meshed surface and its rooftop functions, one for each pair of elements at a side.
#pragma once

#include <array>
#include <memory>

#include "curved_element.h"

namespace paver::validation {

/// Of the function of a side: vector density A = a r_u + b r_v (the function times the Jacobian), at (u, v). Its flux
/// through that side is 1, through the others 0.
struct Density {
  double a, b;
};
Density rooftop(int corners, int side, double u, double v);
/// Its divergence times the Jacobian: the same everywhere.
inline double divergence(int corners) { return corners == 4 ? 1 : 2; }

/// A share of a side's function in a function of the surface.
struct Share {
  int function;
  double sign;
};

class MeshedSurface {
 public:
  /// `nodes` (n x 3), `quads` and `triangles`: numbers of nodes, one row per element. Throws std::invalid_argument.
  MeshedSurface(const Eigen::MatrixX3d& nodes, const Eigen::MatrixXi& quads, const Eigen::MatrixXi& triangles);

  const std::vector<CurvedElement>& elements() const { return elements_; }
  /// A side with m elements has m - 1 functions, from the first to each of the others; a free one has none.
  int functions() const { return functions_; }
  const std::vector<Share>& shares(std::size_t element, int side) const {
    return shares_[element][static_cast<std::size_t>(side)];
  }
  /// Every side has two elements.
  bool is_closed() const { return is_closed_; }
  /// 1 where normals r_u x r_v point out of a closed surface, else -1.
  double outward() const { return outward_; }

 private:
  void add(const Eigen::MatrixX3d& nodes, const Eigen::MatrixXi& rows, int corners);
  void pair_sides();

  std::vector<std::unique_ptr<ShapeFunctions>> shapes_;
  std::vector<CurvedElement> elements_;
  std::vector<std::array<std::vector<Share>, 4>> shares_;
  int functions_ = 0;
  bool is_closed_ = true;
  double outward_ = 1;
};

}  // namespace paver::validation
