// Rules for two triangles: smooth integrals as products have them, singular ones against finer rules.
#include "quadrature.h"

#include <gtest/gtest.h>

namespace paver::validation {
namespace {

template <class F>
double integral(int common, int points, const F& f) {
  double sum = 0;
  for (const PairPoint& p : pair_rule(common, points)) sum += p.weight * f(p.first, p.second);
  return sum;
}

class PairRules : public testing::TestWithParam<int> {};

TEST_P(PairRules, CoverBothTrianglesOnce) {
  const auto f = [](Eigen::Vector2d x, Eigen::Vector2d y) { return (1 + x.x() * x.y()) * (y.x() - 2 * y.y() * y.y()); };
  // Over the triangle: 1 -> 1/2, x -> 1/3, y^2 -> 1/12, x y -> 1/8.
  EXPECT_NEAR(integral(GetParam(), 6, f), (0.5 + 0.125) * (1.0 / 3 - 2.0 / 12), 1e-12);
}

/// The second triangle: the first one itself, turned up about its side or its corner, or above it.
Eigen::Vector3d other_place(int common, Eigen::Vector2d p) {
  if (common == 3) return {p.x(), p.y(), 0};
  if (common == 2) return {p.x(), 0, p.y()};
  if (common == 1) return {0, p.y(), p.x()};
  return {p.x(), p.y(), 1};
}

TEST_P(PairRules, ConvergeWhereThePointsMeet) {
  const auto f = [](Eigen::Vector2d x, Eigen::Vector2d y) {
    return 1 / (Eigen::Vector3d(x.x(), x.y(), 0) - other_place(GetParam(), y)).norm();
  };
  const double fine = integral(GetParam(), 10, f);
  EXPECT_NEAR(integral(GetParam(), 6, f), fine, 1e-5 * fine);
  EXPECT_NEAR(integral(GetParam(), 4, f), fine, 1e-3 * fine);
}

INSTANTIATE_TEST_SUITE_P(Common, PairRules, testing::Values(0, 1, 2, 3));

TEST(ProductRules, IntegratePolynomialsOverQuadsAndTriangles) {
  double quad = 0, triangle = 0;
  for (const RulePoint& p : product_rule(4, 3)) quad += p.weight * p.u * p.u * p.v;
  for (const RulePoint& p : product_rule(3, 3)) triangle += p.weight * p.u * p.u * p.v;
  EXPECT_NEAR(quad, 1.0 / 6, 1e-14);
  EXPECT_NEAR(triangle, 1.0 / 60, 1e-14);
}

}  // namespace
}  // namespace paver::validation
