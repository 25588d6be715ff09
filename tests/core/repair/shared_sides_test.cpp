#include "repair/shared_sides.h"

#include <gtest/gtest.h>

#include "charts/chart.h"
#include "support/fake_model.h"
#include "support/planar_region.h"

namespace paver {
namespace {

/// Two quads in a rectangle of six nodes; 1 and 4 are the ends of the side between them.
///
///    5---4---3
///    |   |   |
///    0---1---2
struct TwoQuads {
  TwoQuads() : region(test::planar_region({{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {0, 1}}}, 1)) {
    for (const LoopNode& node : region.loops[0]) {
      const int i = mesh.add_node(node.p, node.x, {1, 0, 0}, {0, 1, 0}, 1);
      mesh.is_fixed[i] = 1, mesh.global[i] = node.global;
    }
    mesh.add_element({0, 1, 4, 5});
    mesh.add_element({1, 2, 3, 4});
  }
  long alive() const {
    long count = 0;
    for (const Element& e : mesh.elements) count += e.is_alive();
    return count;
  }
  Region region;
  RegionMesh mesh;
};

TEST(DivideInnerSides, PutsANodeInTheMiddleAndDividesBothElements) {
  TwoQuads t;
  divide_inner_sides(t.region, std::vector<InnerSide>{{1, 4, 0, 1, 4}}, t.mesh);
  ASSERT_EQ(t.mesh.node_count(), 7);
  EXPECT_EQ(t.mesh.p[6], (Vec2{1, 0.5}));
  EXPECT_EQ(t.mesh.global[6], -1);
  EXPECT_EQ(t.alive(), 4);
  EXPECT_DOUBLE_EQ(test::chart_area(t.mesh), 2);
  for (const Element& e : t.mesh.elements) EXPECT_TRUE(!e.is_alive() || is_positive(t.mesh, e));
}

TEST(DivideInnerSides, LeavesTheBoundaryAndWhatIsNoSide) {
  TwoQuads t;
  divide_inner_sides(t.region, std::vector<InnerSide>{{0, 1, 0, 0, 1}, {0, 4, 0, 0, 4}, {2, 3, 0, 2, 3}}, t.mesh);
  EXPECT_EQ(t.mesh.node_count(), 6);
  EXPECT_EQ(t.alive(), 2);
}

TEST(DivideInnerSides, DividesTriangles) {
  TwoQuads t;
  t.mesh.remove_element(0);
  t.mesh.add_element({0, 1, 4, -1});
  t.mesh.add_element({0, 4, 5, -1});
  divide_inner_sides(t.region, std::vector<InnerSide>{{0, 4, 0, 0, 4}}, t.mesh);
  EXPECT_EQ(t.alive(), 5);
  EXPECT_DOUBLE_EQ(test::chart_area(t.mesh), 2);
}

TEST(DivideInnerSides, DividesThinElementsInAPolarChart) {
  // About a wall a chord of the chart lies farther up than the thin quad between two of them is high.
  Region region;
  region.surface = std::make_shared<fake::Cylinder>(2);
  region.chart = make_polar_chart(*region.surface, {{0, 0}, {2 * fake::pi, 5}}, 2 * fake::pi);
  RegionMesh mesh;
  for (const Vec2 uv : {Vec2{1.1, 2.6}, {2.0, 2.6}, {2.0, 2.7}, {1.1, 2.7}, {1.1, 1.5}, {2.0, 1.5}}) {
    mesh.add_node(region.place(region.chart->to_chart(uv)), 1);
    mesh.is_fixed.back() = 1, mesh.global.back() = mesh.node_count() - 1;
  }
  const bool is_turned = cross(mesh.p[1] - mesh.p[0], mesh.p[3] - mesh.p[0]) < 0;
  mesh.add_element(is_turned ? std::array{0, 3, 2, 1} : std::array{0, 1, 2, 3});
  mesh.add_element(is_turned ? std::array{4, 0, 1, 5} : std::array{4, 5, 1, 0});
  const auto made = divide_inner_sides(region, std::vector<InnerSide>{{0, 1, 0, 0, 1}}, mesh);
  ASSERT_EQ(made.size(), 1u);
  EXPECT_NEAR(made[0].z, 2.6, 1e-6);
}

TEST(InnerSides, AreThoseBetweenTwoElementsAndTwoNodesOfTheBoundary) {
  TwoQuads t;
  EXPECT_EQ(inner_sides(t.mesh, 7, 6), (std::vector<InnerSide>{{1, 4, 7, 1, 4}}));
  EXPECT_TRUE(inner_sides(t.mesh, 7, 4).empty());  // 4 is a node of an outline
  t.mesh.global[1] = -1;
  EXPECT_TRUE(inner_sides(t.mesh, 7, 6).empty());
}

TEST(SidesToPart, AreAllButTheFirst) {
  const std::vector<InnerSide> all{{1, 4, 2, 0, 3}, {1, 4, 0, 5, 6}, {1, 5, 1, 0, 1}, {1, 4, 1, 7, 8}};
  EXPECT_EQ(sides_to_part(all, {}, {}), (std::vector<InnerSide>{{1, 4, 1, 7, 8}, {1, 4, 2, 0, 3}}));
}

TEST(SidesToPart, AreAllWhereAnEdgeRunsBetweenTheSameNodes) {
  TwoQuads t;
  for (LoopNode& node : t.region.loops[0]) node.edge = 0;
  EdgeNodes nodes;
  nodes.edges.resize(1);
  nodes.edges[0].node = {0, 4, 1};
  const std::vector<InnerSide> all{{1, 4, 0, 1, 4}, {1, 3, 0, 1, 3}};
  EXPECT_EQ(sides_to_part(all, {&t.region, 1}, nodes), (std::vector<InnerSide>{{1, 4, 0, 1, 4}}));
}

}  // namespace
}  // namespace paver
