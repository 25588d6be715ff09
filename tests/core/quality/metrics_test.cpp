#include "quality/metrics.h"

#include <gtest/gtest.h>

#include <numbers>

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

TEST(ScaledJacobian, IsOneForSquaresAndEquilateralTrianglesOfAnySize) {
  for (double s : {1e-3, 1.0, 1e5}) {
    EXPECT_NEAR(scaled_jacobian({0, 0, s}, {s, 0, s}, {s, s, s}, {0, s, s}), 1, 1e-15);
    EXPECT_NEAR(scaled_jacobian({0, 0, 0}, {s, 0, 0}, {s / 2, s * std::sqrt(0.75), 0}), 1, 1e-15);
  }
}

TEST(ScaledJacobian, IsTheSineOfTheWorstCornerOfAParallelogram) {
  double a = pi / 5;
  EXPECT_NEAR(scaled_jacobian({0, 0, 0}, {2, 0, 0}, {2 + std::cos(a), std::sin(a), 0}, {std::cos(a), std::sin(a), 0}),
              std::sin(a), 1e-15);
}

TEST(ScaledJacobian, IsNegativeForConcaveQuadsAndZeroForFlatOnes) {
  EXPECT_LT(scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0.2, 0.2, 0}, {0, 1, 0}), -0.1);
  EXPECT_NEAR(scaled_jacobian({0, 0, 0}, {1, 0, 0}, {0.5, 0.5, 0}, {0, 1, 0}), 0, 1e-15);
  EXPECT_EQ(scaled_jacobian({0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}), 0);
  EXPECT_EQ(scaled_jacobian({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
}

}  // namespace
}  // namespace paver
