#include "repair/shared_sides.h"

#include <gtest/gtest.h>

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
