// What a conducting surface scatters when a plane wave meets it.
#pragma once

#include <memory>
#include <vector>

#include "factors.h"

namespace paver::validation {

/// Polarisations: 0 along theta (vertical), 1 along phi (horizontal). Amplitudes F are such that the radar
/// cross-section is 4 pi |F|^2.
class Scatterer {
 public:
  Scatterer(const MeshedSurface& surface, const Settings& settings);

  /// Back to where each wave comes from; `angles`: theta and phi, radians, one row per wave. One row per wave with the
  /// amplitudes theta-theta and phi-phi.
  Eigen::MatrixX2cd monostatic(const Eigen::MatrixX2d& angles) const;
  /// Of the wave from `from` with one polarisation, in the directions `to`: amplitudes along theta and phi.
  Eigen::MatrixX2cd bistatic(const Eigen::Vector2d& from, int polarisation, const Eigen::MatrixX2d& to) const;
  /// Seconds that filling and solving took.
  double fill_seconds() const { return fill_seconds_; }
  double solve_seconds() const { return solve_seconds_; }

 private:
  struct Direction {
    Vec out;  ///< towards where a wave comes from or goes to
    Vec polarisation[2];
  };
  static Direction direction(const Eigen::Vector2d& angles);
  /// A place on an element: the densities of its sides there, times the weight.
  struct Place {
    Vec x, normal;
    std::vector<Vec> density;
  };
  /// Moments of a plane wave from there with this electric field; `magnetic`: of its magnetic field across the normal.
  Eigen::VectorXcd moments(const Direction& from, const Vec& field, bool magnetic) const;
  Eigen::VectorXcd excitation(const Direction& from, int polarisation) const;

  const MeshedSurface& surface_;
  Settings settings_;
  std::vector<std::vector<Place>> places_;  // by element
  std::unique_ptr<Factors> factors_;
  double fill_seconds_ = 0, solve_seconds_ = 0;
};

}  // namespace paver::validation
