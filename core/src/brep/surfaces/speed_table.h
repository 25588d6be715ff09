// The speed |xu x xv| of a surface as polynomials over cells of (u, v), whose integrals along u are known.
#pragma once

#include <array>
#include <vector>

#include "brep/surfaces/surface.h"

namespace paver {

class SpeedTable {
 public:
  static constexpr int order = 6;  ///< Legendre polynomials of a cell in each direction
  using Values = std::array<double, order>;

  /// Between lines of u and of v, at least two each, at which the surface may be less smooth. Cells are halved where
  /// they are not as near as some 1e-6 of the mean speed.
  SpeedTable(const Surface& surface, const std::vector<double>& u, const std::vector<double>& v);

  /// Integral of the speed along u from the first line on; by the column of cells about `v`, of which there are two on
  /// a line between them. Beyond the lines it is that at the nearest place.
  double up_to(Vec2 uv, double v) const;

  /// Lines of v with `from` < v < `to` between columns of cells, ascending.
  std::vector<double> lines_between(double from, double to) const;

 private:
  struct Cell {
    double u0 = 0, u1 = 0;
    std::array<Values, order> shares{};  ///< [polynomial of u][polynomial of v], times half the width
    Values before{};                     ///< integral along u up to u0, [polynomial of v]
  };
  struct Column {
    double v0 = 0, v1 = 0;
    std::vector<Cell> cells;
  };

  double speed(Vec2 uv) const;
  void add_column(double v0, double v1, int halves);
  bool add_cells(Column& column, double u0, double u1, int halves, bool may_halve_column);
  Cell make_cell(const Column& column, double u0, double u1) const;

  const Surface& surface_;
  const std::vector<double>& u_;
  double allowed_ = 0;
  std::size_t extra_cells_ = 0;
  std::vector<Column> columns_;
};

}  // namespace paver
