// Moments of the electric, magnetic and combined field integral equations on perfectly conducting surfaces.
#pragma once

#include <complex>

#include "surface.h"

namespace paver::validation {

constexpr double free_space_impedance = 376.730313668;  // ohm

struct Settings {
  double wave_number = 0;  ///< 1 / unit of the nodes
  /// Share of the electric field equation: 1 that alone, 0 the magnetic one alone. Below 1 on closed surfaces only.
  double electric_share = 1;
  int threads = 0;          ///< 0: all cores
  int singular_points = 4;  ///< in each of four directions, where elements touch
};

using Matrix = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Tested by the functions themselves, one row and one column per function. Times depend as exp(j w t).
Matrix moment_matrix(const MeshedSurface& surface, const Settings& settings);

/// Throws std::invalid_argument where the settings do not fit the surface.
void check(const MeshedSurface& surface, const Settings& settings);

}  // namespace paver::validation
