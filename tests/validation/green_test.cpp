// Loops over many points against the same one by one.
#include "green.h"

#include <gtest/gtest.h>

#include <vector>

namespace paver::validation {
namespace {

using Complex = std::complex<double>;

TEST(Green, MeetsTheExponentialAtAllDistances) {
  std::vector<double> squares;
  for (double r = 1e-6; r < 3e4; r *= 1.037) squares.push_back(r * r);
  const double k = 1.7;
  std::vector<double> re(squares.size()), im(re), slope_re(re), slope_im(re);
  const Values g{re.data(), im.data()}, by{slope_re.data(), slope_im.data()};
  green(squares.data(), squares.size(), k, g);
  slope(squares.data(), g, squares.size(), k, by);
  slope(squares.data(), g, squares.size(), k, g);
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double r = std::sqrt(squares[i]);
    const Complex value = std::exp(Complex(0, -k * r)) / (4 * M_PI * r);
    const Complex slope = -(1.0 + Complex(0, k * r)) * value / squares[i];
    EXPECT_LT(std::abs(Complex(slope_re[i], slope_im[i]) - slope), 1e-11 * std::abs(slope)) << r;
    EXPECT_EQ(re[i], slope_re[i]) << "in place, " << r;
  }
}

TEST(Green, IsAsExactAsTheLibraryWithinSomeTurns) {
  std::vector<double> squares, re(2000), im(2000);
  for (int i = 1; i <= 2000; ++i) squares.push_back(1e-2 * i * i);
  green(squares.data(), squares.size(), 1, {re.data(), im.data()});
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const double r = std::sqrt(squares[i]), by = 4 * M_PI * r;
    EXPECT_NEAR(by * re[i], std::cos(r), 4e-15) << r;
    EXPECT_NEAR(by * im[i], -std::sin(r), 4e-15) << r;
  }
}

TEST(Sums, AreThoseOfTheFormula) {
  constexpr std::size_t tests = 9, sources = 4;
  std::vector<double> re(tests * sources), im(re), rows(tests * columns), sum_re(tests * columns), sum_im(sum_re);
  for (std::size_t i = 0; i < re.size(); ++i) re[i] = std::sin(1. + i), im[i] = std::cos(2. * i);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = std::sin(3. + 0.7 * i);
  add_sources({re.data(), im.data()}, tests, sources, rows.data(), {sum_re.data(), sum_im.data()});
  double block_re[16], block_im[16];
  add_tests(rows.data(), {sum_re.data(), sum_im.data()}, tests, {block_re, block_im});
  for (std::size_t s = 0; s < 4; ++s)
    for (std::size_t t = 0; t < 4; ++t) {
      Complex wanted = 0;
      for (std::size_t i = 0; i < tests; ++i)
        for (std::size_t j = 0; j < sources; ++j)
          for (std::size_t axis = 0; axis < 12; axis += 4)
            wanted += rows[i * columns + axis + s] * rows[j * columns + axis + t] *
                      Complex(re[i * sources + j], im[i * sources + j]);
      EXPECT_LT(std::abs(Complex(block_re[4 * s + t], block_im[4 * s + t]) - wanted), 1e-12);
    }
}

TEST(Sums, OfPairsTakeEveryPair) {
  constexpr std::size_t count = 21;  // some more than whole vectors
  std::vector<double> a(3 * count), b(a), re(count, 1), im(count);
  Complex wanted = 0;
  for (std::size_t i = 0; i < count; ++i) {
    im[i] = 0.5 * i;
    for (std::size_t k = i; k < a.size(); k += count)
      a[k] = 1. + k, b[k] = 2. - k, wanted += a[k] * b[k] * Complex(1, im[i]);
  }
  EXPECT_LT(std::abs(paired_sum(a.data(), b.data(), {re.data(), im.data()}, count) - wanted), 1e-9);
}

}  // namespace
}  // namespace paver::validation
