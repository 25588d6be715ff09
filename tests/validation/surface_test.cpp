// Elements of all orders, and the functions on their sides.
#include "surface.h"

#include <gtest/gtest.h>

namespace paver::validation {
namespace {

class Orders : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Orders, FunctionsOfNodesAddUpToOne) {
  const auto [corners, nodes] = GetParam();
  const ShapeFunctions shape(corners, nodes);
  const Eigen::MatrixXd at = shape.at(0.3, 0.45);
  EXPECT_NEAR(at.row(0).sum(), 1, 1e-12);
  EXPECT_NEAR(at.row(1).sum(), 0, 1e-12);
  EXPECT_NEAR(at.row(2).sum(), 0, 1e-12);
  for (int i = 0; i < corners; ++i) {
    const Eigen::Vector2d uv = parameters_of(corners, i);
    EXPECT_NEAR(shape.at(uv.x(), uv.y())(0, i), 1, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Orders,
                         testing::Values(std::pair{4, 4}, std::pair{4, 9}, std::pair{4, 16}, std::pair{3, 3},
                                         std::pair{3, 6}, std::pair{3, 10}));

TEST(Rooftops, HaveUnitFluxThroughTheirSideAlone) {
  // Flux per length in parameters: the component across the side.
  for (int side = 0; side < 4; ++side) {
    EXPECT_EQ(-rooftop(4, side, 0.3, 0).b, side == 0 ? 1 : 0);
    EXPECT_EQ(rooftop(4, side, 1, 0.3).a, side == 1 ? 1 : 0);
    EXPECT_EQ(rooftop(4, side, 0.3, 1).b, side == 2 ? 1 : 0);
    EXPECT_EQ(-rooftop(4, side, 0, 0.3).a, side == 3 ? 1 : 0);
  }
  for (int side = 0; side < 3; ++side) {
    const Density slanted = rooftop(3, side, 0.25, 0.75);
    EXPECT_EQ(-rooftop(3, side, 0.3, 0).b, side == 0 ? 1 : 0);
    EXPECT_EQ(slanted.a + slanted.b, side == 1 ? 1 : 0);
    EXPECT_EQ(-rooftop(3, side, 0, 0.3).a, side == 2 ? 1 : 0);
  }
}

TEST(MeshedSurface, ASideOfThreeElementsHasTwoFunctionsAFreeOneNone) {
  Eigen::MatrixX3d nodes(5, 3);
  nodes << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1;
  Eigen::MatrixXi triangles(3, 3);
  triangles << 0, 1, 2, 1, 0, 3, 0, 1, 4;
  const MeshedSurface surface(nodes, Eigen::MatrixXi(0, 4), triangles);
  EXPECT_EQ(surface.functions(), 2);
  EXPECT_FALSE(surface.is_closed());
  EXPECT_EQ(surface.shares(0, 0).size(), 2U);
  EXPECT_EQ(surface.shares(1, 0).size(), 1U);
  EXPECT_EQ(surface.shares(0, 1).size(), 0U);
}

TEST(MeshedSurface, RefusesElementsWithoutNodes) {
  Eigen::MatrixX3d nodes = Eigen::MatrixX3d::Zero(3, 3);
  Eigen::MatrixXi triangles(1, 3);
  triangles << 0, 1, 3;
  EXPECT_THROW(MeshedSurface(nodes, Eigen::MatrixXi(0, 4), triangles), std::invalid_argument);
  EXPECT_THROW(MeshedSurface(nodes, Eigen::MatrixXi(0, 4), Eigen::MatrixXi(0, 3)), std::invalid_argument);
  EXPECT_THROW(ShapeFunctions(4, 8), std::invalid_argument);
}

}  // namespace
}  // namespace paver::validation
