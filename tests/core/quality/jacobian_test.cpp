#include "quality/jacobian/jacobian.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "quality/jacobian/lattice.h"

namespace paver {
namespace {

using Map = Vec3 (*)(double u, double v);

/// Nodes of one element at the images of its lattice.
std::vector<Vec3> element(ElementShape shape, int p, Map map) {
  std::vector<Vec3> nodes;
  for (auto [i, j] : lagrange_nodes(shape, p))
    nodes.push_back(map(static_cast<double>(i) / p, static_cast<double>(j) / p));
  return nodes;
}

class AnyElement : public testing::TestWithParam<std::tuple<ElementShape, int>> {
 protected:
  ElementShape shape() const { return std::get<0>(GetParam()); }
  int order() const { return std::get<1>(GetParam()); }
  const JacobianForm& form() const { return jacobian_form(shape(), order()); }
  bool is_quad() const { return shape() == ElementShape::quad; }
};

INSTANTIATE_TEST_SUITE_P(Orders, AnyElement,
                         testing::Combine(testing::Values(ElementShape::quad, ElementShape::triangle),
                                          testing::Range(1, JacobianForm::max_order + 1)));

TEST_P(AnyElement, OfAffineShapeHasRatioOneAndItsArea) {
  auto x = element(shape(), order(), [](double u, double v) { return Vec3{7 + 2 * u + v, 3 * v, 2 * u + v}; });
  JacobianBound bound = form().bound(x.data());
  EXPECT_EQ(bound.validity, Validity::valid);
  EXPECT_NEAR(bound.ratio, 1, 1e-12);
  EXPECT_NEAR(form().area(x.data()), norm(cross({2, 0, 2}, {1, 3, 1})) * (is_quad() ? 1 : 0.5), 1e-12);
}

TEST_P(AnyElement, TurnedInsideOutByOneCornerIsInvalid) {
  auto x = element(shape(), order(), [](double u, double v) { return Vec3{u, v, 0}; });
  if (!is_quad() && order() == 1) return;  // a straight triangle cannot fold
  x[0] = {0.9, 0.9, 0};
  EXPECT_EQ(form().bound(x.data()).validity, Validity::invalid);
  EXPECT_FALSE(form().is_valid(x.data()));
  EXPECT_LE(form().bound(x.data()).ratio, 0);
}

TEST_P(AnyElement, WithoutAreaOrWithNanIsInvalid) {
  auto x = element(shape(), order(), [](double u, double v) { return Vec3{u + v, u + v, 0}; });
  EXPECT_EQ(form().bound(x.data()).validity, Validity::invalid);
  x[1].z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(form().bound(x.data()).validity, Validity::invalid);
}

TEST_P(AnyElement, BoundIsBelowSampledValuesAndDoesNotDependOnPlaceAndSize) {
  auto x = element(shape(), order(), [](double u, double v) {
    return Vec3{u + 0.2 * v * v, v - 0.25 * u * u + 0.1 * u * v, 0.3 * u * v};
  });
  auto moved = x;
  for (Vec3& point : moved) point = Vec3{1e4, -2e4, 3e4} + 500.0 * Vec3{point.y, point.z, point.x};
  JacobianBound bound = form().bound(x.data());
  EXPECT_EQ(bound.validity, Validity::valid);
  EXPECT_GT(bound.ratio, 0.3);
  EXPECT_LE(bound.ratio, 1 + 1e-12);
  EXPECT_NEAR(form().bound(moved.data()).ratio, bound.ratio, 1e-9);
}

/// Middle node of one side of a square moved along that side: valid while it stays within its middle half.
std::vector<Vec3> square_with_middle_at(double t) {
  auto x = element(ElementShape::quad, 2, [](double u, double v) { return Vec3{u, v, 0}; });
  x[4].x = t;
  return x;
}

TEST_P(AnyElement, HasTheSameLowestCoefficientAmongOthersAsAlone) {
  constexpr int lanes = JacobianForm::lanes;
  JacobianForm::Lanes x[3 * JacobianForm::max_nodes], low;
  std::vector<JacobianForm::LaneFigures> alone(lanes);
  std::vector<std::vector<Vec3>> elements;
  for (int lane = 0; lane < lanes; ++lane) {
    std::vector<Vec3> nodes = element(shape(), order(), [](double u, double v) { return Vec3{u, v, 0.1 * u * v}; });
    nodes[2].x -= 0.2 * lane, nodes[2].y -= 0.2 * lane;  // the last quad is no longer convex
    elements.push_back(nodes);
  }
  auto put = [&](int lane, const std::vector<Vec3>& nodes) {
    for (std::size_t k = 0; k < nodes.size(); ++k)
      x[3 * k].of[lane] = nodes[k].x, x[3 * k + 1].of[lane] = nodes[k].y, x[3 * k + 2].of[lane] = nodes[k].z;
  };
  for (int which = 0; which < lanes; ++which) {
    for (int lane = 0; lane < lanes; ++lane) put(lane, elements[which]);
    form().measure_lanes(x, alone[which]);
  }
  for (int lane = 0; lane < lanes; ++lane) put(lane, elements[lane]);
  form().bound_lanes(x, low);
  for (int lane = 0; lane < lanes; ++lane) {
    EXPECT_EQ(low.of[lane], alone[lane].low.of[0]);
    EXPECT_EQ(low.of[lane] > 0 || form().is_valid(elements[lane].data()), form().is_valid(elements[lane].data()));
  }
  EXPECT_GT(low.of[0], 0);
  EXPECT_TRUE(!is_quad() || order() > 1 || low.of[lanes - 1] <= 0);
}

TEST(JacobianForm, DecidesWhereAMiddleNodeFoldsASide) {
  const JacobianForm& form = jacobian_form(ElementShape::quad, 2);
  EXPECT_TRUE(form.is_valid(square_with_middle_at(0.26).data()));
  EXPECT_TRUE(form.is_valid(square_with_middle_at(0.74).data()));
  EXPECT_FALSE(form.is_valid(square_with_middle_at(0.24).data()));
  EXPECT_FALSE(form.is_valid(square_with_middle_at(0.76).data()));
}

TEST(JacobianForm, ACornerOfHalfATurnIsInvalidWhicheverWayItIsRounded) {
  const JacobianForm& form = jacobian_form(ElementShape::quad, 1);
  for (double off : {-1e-14, 0.0, 1e-14, 1e-7}) {
    const std::array<Vec3, 4> x{Vec3{0, 0, 0}, {1, -off, 0}, {2, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(form.is_valid(x.data()), off > 1e-8) << off;
  }
}

TEST(JacobianForm, SplitsUntilTheSignIsCertainThoughACoefficientIsNegative) {
  // On the side, x_u is quadratic and everywhere positive, but its middle coefficient is not.
  auto x = element(ElementShape::quad, 2, [](double u, double v) { return Vec3{u, v, 0}; });
  for (int k : {4, 6, 8}) x[k].y += 0.4;  // an arch: the determinant varies strongly, but keeps its sign
  EXPECT_TRUE(jacobian_form(ElementShape::quad, 2).is_valid(x.data()));
  JacobianBound bound = jacobian_form(ElementShape::quad, 2).bound(x.data());
  EXPECT_EQ(bound.validity, Validity::valid);
  EXPECT_GT(bound.ratio, 0);
}

TEST(JacobianForm, AreaOfAQuarterDiscOfOrderFourIsCloseToTheTrueOne) {
  auto x = element(ElementShape::quad, 4, [](double u, double v) {
    double r = 1 + u, a = v * std::numbers::pi / 2;
    return Vec3{r * std::cos(a), r * std::sin(a), 0};
  });
  EXPECT_NEAR(jacobian_form(ElementShape::quad, 4).area(x.data()), 0.75 * std::numbers::pi, 2e-4);
}

}  // namespace
}  // namespace paver
