// Evaluation of B-spline surfaces. OpenCASCADE's own turns the span into a polynomial on every change of span, which
// paving and clean-up, that jump about, make nearly every time.
#pragma once

#include <memory>
#include <vector>

#include "brep/surfaces/surface.h"

namespace paver {

/// Basis functions over knots with repetitions (count + degree + 1 of them), not periodic.
class SplineBasis {
 public:
  static constexpr int most_degree = 25;
  /// Values and derivatives of the degree + 1 functions that are not 0 on a span.
  struct Values {
    double value[most_degree + 1], first[most_degree + 1], second[most_degree + 1];
  };

  SplineBasis() = default;
  SplineBasis(int degree, std::vector<double> knots);
  int degree() const { return degree_; }
  int count() const { return count_; }
  /// Index i with knots[i] <= t < knots[i + 1], beyond the ends the first or last such; `last` is tried first.
  int find_span(double t, int last) const;
  /// Derivatives up to `order`; function i of the result belongs to pole span - degree + i.
  template <int order>
  void evaluate(int span, double t, Values& out) const;

 private:
  template <int fixed, int order>
  void recur(int span, double t, Values& out) const;
  const double* shares(int k, int span) const { return &share_[(k - 1) * knots_.size() + span + 1 - k]; }

  int degree_ = 1, count_ = 0;
  std::vector<double> knots_;
  std::vector<double> share_;  // [k - 1][i]: 1 / (knots[i + k] - knots[i]), 0 where that is empty
};

/// Homogeneous coordinates.
struct alignas(32) Pole {
  using Pair = double __attribute__((vector_size(16)));
  Pair xy{}, zw{};
};

/// poles[i * v.count() + j] belongs to the i-th basis function of u and the j-th of v: x, y, z times the weight, and
/// the weight (0 throughout where the surface is polynomial).
struct SplineNet {
  SplineBasis u, v;
  bool is_rational = false;
  std::vector<Pole> poles;
};

/// Keeps the last span, so each task has its own; copies share the net.
class SplineSurface {
 public:
  explicit SplineSurface(std::shared_ptr<const SplineNet> net) : net_(std::move(net)) {}
  /// Derivatives up to `order` (0, 1 or 2); on a knot those of the span after it. Beyond the ends the last spans'
  /// polynomials go on.
  void evaluate(double u, double v, int order, SurfaceJet& jet) const;

 private:
  template <int order>
  void evaluate(double u, double v, SurfaceJet& jet) const;
  template <int order, class Sum, int rows>
  void add_rows(int i, const SplineBasis::Values& bu, const SplineBasis::Values& bv, Sum (&sum)[6]) const;
  template <int order, class Sum>
  void sum_poles(const SplineBasis::Values& bu, const SplineBasis::Values& bv, Pole (&result)[6]) const;
  template <int order>
  void sum_poles_avx2(const SplineBasis::Values& bu, const SplineBasis::Values& bv, Pole (&sum)[6]) const;

  std::shared_ptr<const SplineNet> net_;
  mutable int span_u_ = 0, span_v_ = 0;
};

}  // namespace paver
