#include "curving/order2.h"

#include <gtest/gtest.h>

#include <set>

#include "support/fake_model.h"

namespace paver {
namespace {

// Half of a tube's wall as two quads, one above the other; edges: 0 lower arc, 1 upright, 2 upper arc, 3 upright.
struct Wall {
  Model model;
  EdgeNodes edges;
  SurfaceMesh linear;
};

Wall two_quads() {
  Wall wall;
  fake::Builder builder;
  int a = builder.vertex({1, 0, 0}), b = builder.vertex({0, 1, 0});
  int c = builder.vertex({0, 1, 2}), d = builder.vertex({1, 0, 2});
  int low = builder.arc({}, 1, 0, fake::pi / 2, a, b), right = builder.line(b, c);
  int high = builder.arc({0, 0, 2}, 1, 0, fake::pi / 2, d, c), left = builder.line(a, d);
  builder.face(std::make_shared<fake::Cylinder>(1), fake::pi,
               {{builder.use(low), builder.use(right), builder.use(high, true), builder.use(left, true)}});
  wall.model = builder.take();
  SizeField size;
  size.h = 100;
  size.turn_limit = 2;
  size.faces.assign(1, FaceSize(100));
  Progress progress;
  wall.edges = divide_edges(wall.model, size, {1, 2, 1, 2}, progress);
  // Nodes: 0-3 vertices, 4 on edge 1, 5 on edge 3.
  wall.linear.nodes = wall.edges.nodes;
  wall.linear.node_edge = wall.edges.node_edge;
  wall.linear.node_target = wall.edges.node_target;
  wall.linear.quads = {0, 1, 4, 5, 5, 4, 2, 3};
  wall.linear.quad_face = {0, 0};
  for (std::size_t e = 0; e < 4; ++e) {
    const std::vector<int>& nodes = wall.edges.edges[e].node;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      wall.linear.lines.insert(wall.linear.lines.end(), {nodes[i], nodes[i + 1]});
      wall.linear.line_edge.push_back(static_cast<int>(e));
    }
  }
  return wall;
}

SurfaceMesh raised(const Wall& wall) {
  auto midpoint = [&wall](int, int a, int b) {
    Vec3 m = 0.5 * (wall.linear.nodes[static_cast<std::size_t>(a)] + wall.linear.nodes[static_cast<std::size_t>(b)]);
    double r = std::sqrt(m.x * m.x + m.y * m.y);
    return Vec3{m.x / r, m.y / r, m.z};
  };
  return raise_to_order_2(wall.linear, wall.edges, wall.model, midpoint, nullptr);
}

TEST(RaiseToOrder2, ElementsHaveGmshsNodeOrder) {
  Wall wall = two_quads();
  SurfaceMesh mesh = raised(wall);
  ASSERT_EQ(mesh.order, 2);
  ASSERT_EQ(mesh.quads.size(), 18u);
  auto x = [&mesh](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(mesh.quads[i])]; };
  const double h = std::sqrt(0.5);
  EXPECT_NEAR(norm(x(4) - Vec3{h, h, 0}), 0, 1e-12);    // 01: on the lower arc
  EXPECT_NEAR(norm(x(5) - Vec3{0, 1, 0.5}), 0, 1e-12);  // 12
  EXPECT_NEAR(norm(x(6) - Vec3{h, h, 1}), 0, 1e-12);    // 23
  EXPECT_NEAR(norm(x(7) - Vec3{1, 0, 0.5}), 0, 1e-12);  // 30
  EXPECT_NEAR(norm(x(8) - Vec3{h, h, 0.5}), 0, 1e-12);  // centre: the blend is exact on a cylinder
}

TEST(RaiseToOrder2, NeighboursShareTheMiddleOfTheirSide) {
  SurfaceMesh mesh = raised(two_quads());
  EXPECT_EQ(mesh.quads[6], mesh.quads[9 + 4]);
  EXPECT_EQ(mesh.nodes.size(), 6u + 6 + 1 + 2);
  std::set<int> used(mesh.quads.begin(), mesh.quads.end());
  EXPECT_EQ(used.size(), mesh.nodes.size());
  EXPECT_EQ(mesh.node_edge.size(), mesh.nodes.size());
  EXPECT_EQ(mesh.node_target.size(), mesh.nodes.size());
}

TEST(RaiseToOrder2, MiddlesOfLinesAreThoseOfTheEdgesAndKnowThem) {
  Wall wall = two_quads();
  SurfaceMesh mesh = raised(wall);
  ASSERT_EQ(mesh.lines.size(), 18u);
  EXPECT_EQ(mesh.lines[2], mesh.quads[4]);
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i) {
    EXPECT_EQ(mesh.node_edge[static_cast<std::size_t>(mesh.lines[3 * i + 2])], mesh.line_edge[i]);
  }
  EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(mesh.lines[2])], wall.edges.edges[0].x[1]);
}

TEST(RaiseToOrder2, ASideInsideAnotherFaceDoesNotTakeTheMiddleOfAnEdge) {
  Wall wall = two_quads();
  // A second face without edges of its own has a triangle over the same nodes.
  wall.model.faces.push_back(wall.model.faces[0]);
  wall.linear.triangles = {0, 1, 4};
  wall.linear.triangle_face = {1};
  SurfaceMesh mesh = raised(wall);
  EXPECT_NE(mesh.triangles[3], mesh.quads[4]);
  EXPECT_EQ(mesh.node_edge[static_cast<std::size_t>(mesh.triangles[3])], -1);
}

TEST(RaiseToOrder2, AnEmptyMeshStaysEmpty) {
  SurfaceMesh mesh = raise_to_order_2({}, {}, {}, nullptr, nullptr);
  EXPECT_EQ(mesh.order, 2);
  EXPECT_TRUE(mesh.nodes.empty());
}

}  // namespace
}  // namespace paver
