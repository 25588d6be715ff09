// No branches and no calls in the loops; each function stands in the program once for every kind of processor and once
// more for those with vectors of four.
#include "green.h"

#include <cmath>

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__)
#define PAVER_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define PAVER_CLONES
#endif

namespace paver::validation {
namespace {

// 2 pi in two parts, the first of 33 bits: whole numbers below 2^20 times it are exact.
constexpr double turn_high = 4 * 1.57079632673412561417, turn_low = 4 * 6.07710050650619224932e-11;
constexpr double whole = 6755399441055744.0;  // 1.5 * 2^52: a number plus this has no digits after the point

/// Sine and cosine of x: of a quarter of it less whole turns by series, then twice the angle of twice the angle.
inline void sine_cosine(double x, double& sine, double& cosine) {
  const double turns = (x * (0.5 / M_PI) + whole) - whole;
  const double y = 0.25 * ((x - turns * turn_high) - turns * turn_low), z = y * y;
  double s =
      y * (1 + z * (-1. / 6 +
                    z * (1. / 120 + z * (-1. / 5040 + z * (1. / 362880 +
                                                           z * (-1. / 39916800 + z * (1. / 6227020800. +
                                                                                      z * (-1. / 1307674368000.))))))));
  double c =
      1 + z * (-0.5 +
               z * (1. / 24 +
                    z * (-1. / 720 + z * (1. / 40320 + z * (-1. / 3628800 + z * (1. / 479001600. +
                                                                                 z * (-1. / 87178291200. +
                                                                                      z * (1. / 20922789888000.))))))));
  for (int i = 0; i < 2; ++i) {
    const double twice = 2 * s * c;
    c = 1 - 2 * s * s;
    s = twice;
  }
  sine = s, cosine = c;
}

}  // namespace

PAVER_CLONES void green(const double* squares, std::size_t count, double k, Values found) {
  double *const re = found.re, *const im = found.im;
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    const double r = std::sqrt(squares[i]), by = 1 / (4 * M_PI * r);
    double sine, cosine;
    sine_cosine(k * r, sine, cosine);
    re[i] = cosine * by;
    im[i] = -sine * by;
  }
}

PAVER_CLONES void slope(const double* squares, Values green, std::size_t count, double k, Values found) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < count; ++i) {
    const double by = -1 / squares[i], kr = k * std::sqrt(squares[i]), re = green.re[i], im = green.im[i];
    found.re[i] = by * (re - kr * im);
    found.im[i] = by * (im + kr * re);
  }
}

PAVER_CLONES void add_sources(Values values, std::size_t tests, std::size_t sources, const double* rows, Values found) {
  for (std::size_t i = 0; i < tests; ++i) {
    double re[columns] = {}, im[columns] = {};
    for (std::size_t j = 0; j < sources; ++j) {
      const double a = values.re[i * sources + j], b = values.im[i * sources + j];
      for (std::size_t c = 0; c < columns; ++c) re[c] += a * rows[j * columns + c];
      for (std::size_t c = 0; c < columns; ++c) im[c] += b * rows[j * columns + c];
    }
    for (std::size_t c = 0; c < columns; ++c) found.re[i * columns + c] = re[c], found.im[i * columns + c] = im[c];
  }
}

PAVER_CLONES void add_tests(const double* rows, Values sums, std::size_t tests, Values found) {
  double re[16] = {}, im[16] = {};
  for (std::size_t at = 0; at < tests * columns; at += columns)
    for (std::size_t axis = 0; axis < 12; axis += 4)
      for (std::size_t s = 0; s < 4; ++s) {
        const double a = rows[at + axis + s];
        for (std::size_t t = 0; t < 4; ++t) re[4 * s + t] += a * sums.re[at + axis + t];
        for (std::size_t t = 0; t < 4; ++t) im[4 * s + t] += a * sums.im[at + axis + t];
      }
  for (std::size_t i = 0; i < 16; ++i) found.re[i] = re[i], found.im[i] = im[i];
}

PAVER_CLONES std::complex<double> paired_sum(const double* a, const double* b, Values values, std::size_t count) {
  constexpr std::size_t lanes = 8;  // sums of their own: additions keep their order whatever the processor
  double re[lanes] = {}, im[lanes] = {};
  const auto add = [&](std::size_t i, std::size_t lane) {
    const double dot = a[i] * b[i] + a[count + i] * b[count + i] + a[2 * count + i] * b[2 * count + i];
    re[lane] += dot * values.re[i];
    im[lane] += dot * values.im[i];
  };
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(i + lane, lane);
  for (; i < count; ++i) add(i, 0);
  std::complex<double> sum = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) sum += std::complex<double>(re[lane], im[lane]);
  return sum;
}

}  // namespace paver::validation
