#include "scattering.h"

#include <chrono>
#include <cmath>
#include <complex>
#include <utility>

#include "quadrature.h"

namespace paver::validation {
namespace {

using Complex = std::complex<double>;
constexpr int wave_points = 5;  // each way on an element

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Scatterer::Scatterer(const MeshedSurface& surface, const Settings& settings) : surface_(surface), settings_(settings) {
  auto start = std::chrono::steady_clock::now();
  Matrix matrix = moment_matrix(surface, settings);
  fill_seconds_ = seconds_since(start);
  start = std::chrono::steady_clock::now();
  factors_ = std::make_unique<Factors>(std::move(matrix));
  solve_seconds_ = seconds_since(start);
  for (const CurvedElement& element : surface.elements()) {
    std::vector<Place>& there = places_.emplace_back();
    for (const RulePoint& q : product_rule(element.corners(), wave_points)) {
      const ElementPoint at = element.at(q.u, q.v);
      Place& place = there.emplace_back(at.x, surface.outward() * at.by_u.cross(at.by_v).normalized());
      for (int side = 0; side < element.corners(); ++side) {
        const Density d = rooftop(element.corners(), side, q.u, q.v);
        place.density.push_back(q.weight * (d.a * at.by_u + d.b * at.by_v));
      }
    }
  }
}

Scatterer::Direction Scatterer::direction(const Eigen::Vector2d& angles) {
  const double st = std::sin(angles.x()), ct = std::cos(angles.x()), sp = std::sin(angles.y()),
               cp = std::cos(angles.y());
  return {{st * cp, st * sp, ct}, {{ct * cp, ct * sp, -st}, {-sp, cp, 0}}};
}

Eigen::VectorXcd Scatterer::moments(const Direction& from, const Vec& field, bool magnetic) const {
  Eigen::VectorXcd found = Eigen::VectorXcd::Zero(surface_.functions());
  for (std::size_t e = 0; e < places_.size(); ++e) {
    Complex sums[4] = {};
    for (const Place& place : places_[e]) {
      const Vec tested = magnetic ? place.normal.cross(field) : field;
      const double phase = settings_.wave_number * from.out.dot(place.x);
      const Complex wave(std::cos(phase), std::sin(phase));
      for (std::size_t side = 0; side < place.density.size(); ++side)
        sums[side] += place.density[side].dot(tested) * wave;
    }
    for (int side = 0; side < surface_.elements()[e].corners(); ++side)
      for (const Share& share : surface_.shares(e, side)) found(share.function) += share.sign * sums[side];
  }
  return found;
}

Eigen::VectorXcd Scatterer::excitation(const Direction& from, int polarisation) const {
  const Vec& field = from.polarisation[polarisation];
  Eigen::VectorXcd found = settings_.electric_share * moments(from, field, false);
  // The magnetic field times the impedance, as the equation's rows are.
  if (settings_.electric_share < 1)
    found += (1 - settings_.electric_share) * moments(from, (-from.out).cross(field), true);
  return found;
}

// A far field is the moments of the current with a plane wave from there.
Eigen::MatrixX2cd Scatterer::monostatic(const Eigen::MatrixX2d& angles) const {
  const Complex factor = -Complex(0, 1) * settings_.wave_number * free_space_impedance / (4 * M_PI);
  Eigen::MatrixX2cd found(angles.rows(), 2);
  Eigen::MatrixXcd given(surface_.functions(), 2 * angles.rows());
  for (Eigen::Index i = 0; i < angles.rows(); ++i)
    for (int p = 0; p < 2; ++p) given.col(2 * i + p) = excitation(direction(angles.row(i)), p);
  const Eigen::MatrixXcd currents = factors_->solve(given);
  if (settings_.electric_share < 1)  // else these are the moments already
    for (Eigen::Index i = 0; i < angles.rows(); ++i)
      for (int p = 0; p < 2; ++p) {
        const Direction there = direction(angles.row(i));
        given.col(2 * i + p) = moments(there, there.polarisation[p], false);
      }
  for (Eigen::Index i = 0; i < angles.rows(); ++i)
    for (int p = 0; p < 2; ++p) found(i, p) = factor * given.col(2 * i + p).cwiseProduct(currents.col(2 * i + p)).sum();
  return found;
}

Eigen::MatrixX2cd Scatterer::bistatic(const Eigen::Vector2d& from, int polarisation, const Eigen::MatrixX2d& to) const {
  const Complex factor = -Complex(0, 1) * settings_.wave_number * free_space_impedance / (4 * M_PI);
  const Eigen::VectorXcd current = factors_->solve(excitation(direction(from), polarisation));
  Eigen::MatrixX2cd found(to.rows(), 2);
  for (Eigen::Index i = 0; i < to.rows(); ++i) {
    const Direction there = direction(to.row(i));
    for (int p = 0; p < 2; ++p)
      found(i, p) = factor * moments(there, there.polarisation[p], false).cwiseProduct(current).sum();
  }
  return found;
}

}  // namespace paver::validation
