#include "factors.h"

#include <utility>

namespace paver::validation {

// factorise.cpp, once for each kind of processor.
#define PAVER_KIND(name)                                                \
  namespace name {                                                      \
  void factorise(std::complex<double>* matrix, long rows, int* places); \
  }
PAVER_KIND(any)
#ifdef PAVER_VECTORS
PAVER_KIND(of_four)
PAVER_KIND(of_eight)
#endif

namespace {

auto* fastest() {
#ifdef PAVER_VECTORS
  __builtin_cpu_init();
  const bool has_four =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool has_eight = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                         __builtin_cpu_supports("avx512vl");
  if (has_four && has_eight) return &of_eight::factorise;
  if (has_four) return &of_four::factorise;
#endif
  return &any::factorise;
}

}  // namespace

Factors::Factors(Matrix matrix) : factors_(std::move(matrix)), places_(static_cast<std::size_t>(factors_.rows())) {
  fastest()(factors_.data(), factors_.rows(), places_.data());
}

Eigen::MatrixXcd Factors::solve(const Eigen::MatrixXcd& given) const {
  Eigen::MatrixXcd found(given.rows(), given.cols());
  for (Eigen::Index i = 0; i < given.rows(); ++i) found.row(places_[static_cast<std::size_t>(i)]) = given.row(i);
  factors_.triangularView<Eigen::UnitLower>().solveInPlace(found);
  factors_.triangularView<Eigen::Upper>().solveInPlace(found);
  return found;
}

}  // namespace paver::validation
