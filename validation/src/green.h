// Green's function at many distances at once, and sums with it: loops that compilers make vector code of.
#pragma once

#include <complex>
#include <cstddef>

namespace paver::validation {

/// Real and imaginary parts of as many values.
struct Values {
  double *re, *im;
};

constexpr std::size_t columns = 16;  ///< of a place: along each axis four sides, then the weight, the rest 0
constexpr std::size_t weight_column = 12;

/// exp(-jkR) / 4 pi R for the squares of R. |k R| below 10^6.
void green(const double* squares, std::size_t count, double k, Values found);

/// What times the vector from the source is its gradient, from the same squares and the values themselves, which
/// may lie where these come to.
void slope(const double* squares, Values green, std::size_t count, double k, Values found);

/// Sums over the sources, for each test and column: found[test][column] = sum of values[test][source]
/// rows[source][column].
void add_sources(Values values, std::size_t tests, std::size_t sources, const double* rows, Values found);

/// Sums over the tests: found[s][t] = sum of rows[test][axis, s] . sums[test][axis, t], 4 x 4.
void add_tests(const double* rows, Values sums, std::size_t tests, Values found);

/// Sum of (a . b) value over `count` places; a and b have three columns of `count`.
std::complex<double> paired_sum(const double* a, const double* b, Values values, std::size_t count);

}  // namespace paver::validation
