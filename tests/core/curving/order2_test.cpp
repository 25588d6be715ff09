#include "curving/order2.h"

#include <gtest/gtest.h>

#include <set>

#include "support/alone.h"
#include "support/boundary_use.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Half of a tube's wall as two quads, one above the other; edges: 0 lower arc, 1 upright, 2 upper arc, 3 upright.
struct Wall {
  Wall() {
    fake::Builder builder;
    int a = builder.vertex({1, 0, 0}), b = builder.vertex({0, 1, 0});
    int c = builder.vertex({0, 1, 2}), d = builder.vertex({1, 0, 2});
    int low = builder.arc({}, 1, 0, fake::pi / 2, a, b), right = builder.line(b, c);
    int high = builder.arc({0, 0, 2}, 1, 0, fake::pi / 2, d, c), left = builder.line(a, d);
    builder.face(std::make_shared<fake::Cylinder>(1), fake::pi,
                 {{builder.use(low), builder.use(right), builder.use(high, true), builder.use(left, true)}});
    model = builder.take();
    SizeField size;
    size.h = 100;
    size.turn_limit = 2;
    size.faces.assign(1, FaceSize(100));
    Progress progress;
    test::Alone alone(progress);
    edges = divide_edges(model, size, {{1, 2, 1, 2}, {}}, alone);
    region.face = 0;
    lay(mesh, {0, 1, 4, 5, 2, 3}, {{0, 1, 2, 3}, {3, 2, 4, 5}});
  }

  // Nodes of the boundary stage: 0-3 vertices, 4 on edge 1, 5 on edge 3.
  void lay(RegionMesh& to, const std::vector<int>& nodes, const std::vector<std::array<int, 4>>& elements) const {
    for (int node : nodes) {
      to.add_node({}, edges.nodes[static_cast<std::size_t>(node)], {}, {}, 1);
      to.global.back() = node;
    }
    for (const auto& corners : elements) to.add_element(corners);
  }

  OrderTwoMesh raised(const std::vector<const RegionMesh*>& meshes) const {
    std::vector<Region> regions(meshes.size());
    std::vector<MeshPart> parts;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      regions[i].face = static_cast<int>(i);
      parts.push_back({&regions[i], meshes[i]});
    }
    JoinedMesh joined = join_regions(model, edges, test::all_of(edges), parts);
    for (std::size_t i = 0; i < meshes.size(); ++i) parts[i].node_of = &joined.node_of[i];
    return number_order_2(joined.mesh, {joined.sizes, edges, model, Cuts({}, cuts), parts, 1});
  }
  SurfaceMesh raised() const { return raised({&mesh}).mesh; }

  Model model;
  EdgeNodes edges;
  Region region;
  RegionMesh mesh;
  std::vector<CutSide> cuts;
};

TEST(NumberOrder2, ElementsHaveGmshsNodeOrder) {
  Wall wall;
  SurfaceMesh mesh = wall.raised();
  ASSERT_EQ(mesh.order, 2);
  ASSERT_EQ(mesh.quads.size(), 18u);
  auto x = [&mesh](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(mesh.quads[i])]; };
  const double h = std::sqrt(0.5);
  EXPECT_NEAR(norm(x(4) - Vec3{h, h, 0}), 0, 1e-12);    // 01: on the lower arc
  EXPECT_NEAR(norm(x(5) - Vec3{0, 1, 0.5}), 0, 1e-12);  // 12
  EXPECT_NEAR(norm(x(7) - Vec3{1, 0, 0.5}), 0, 1e-12);  // 30
}

TEST(NumberOrder2, ReversedFacesRunTheOtherWayRound) {
  Wall wall;
  wall.model.faces[0].is_reversed = true;
  SurfaceMesh mesh = wall.raised();
  for (std::size_t q : {0u, 9u})
    for (std::size_t k = 0; k < 4; ++k) {
      auto x = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(mesh.quads[q + i])]; };
      if (mesh.node_edge[static_cast<std::size_t>(mesh.quads[q + 4 + k])] < 0) continue;
      EXPECT_NEAR(norm(x(4 + k) - x(k)), norm(x(4 + k) - x((k + 1) % 4)), 1e-12);  // half way along its own side
    }
}

TEST(NumberOrder2, NeighboursShareTheMiddleOfTheirSide) {
  SurfaceMesh mesh = Wall().raised();
  EXPECT_EQ(mesh.quads[6], mesh.quads[9 + 4]);
  EXPECT_EQ(mesh.nodes.size(), 6u + 6 + 1 + 2);
  std::set<int> used(mesh.quads.begin(), mesh.quads.end());
  EXPECT_EQ(used.size(), mesh.nodes.size());
  EXPECT_EQ(mesh.node_edge.size(), mesh.nodes.size());
  EXPECT_EQ(mesh.node_target.size(), mesh.nodes.size());
}

TEST(NumberOrder2, MiddlesOfLinesAreThoseOfTheEdgesAndKnowThem) {
  Wall wall;
  SurfaceMesh mesh = wall.raised();
  ASSERT_EQ(mesh.lines.size(), 18u);
  EXPECT_EQ(mesh.lines[2], mesh.quads[4]);
  for (std::size_t i = 0; i < mesh.line_edge.size(); ++i) {
    EXPECT_EQ(mesh.node_edge[static_cast<std::size_t>(mesh.lines[3 * i + 2])], mesh.line_edge[i]);
  }
  EXPECT_EQ(mesh.nodes[static_cast<std::size_t>(mesh.lines[2])], wall.edges.edges[0].x[1]);
}

TEST(NumberOrder2, ASideInsideAnotherFaceDoesNotTakeTheMiddleOfAnEdge) {
  Wall wall;
  wall.model.faces.push_back(wall.model.faces[0]);
  RegionMesh triangle;  // of a second face without edges of its own, over the same nodes
  wall.lay(triangle, {0, 1, 4}, {{0, 1, 2, -1}});
  SurfaceMesh mesh = wall.raised({&wall.mesh, &triangle}).mesh;
  EXPECT_NE(mesh.triangles[3], mesh.quads[4]);
  EXPECT_EQ(mesh.node_edge[static_cast<std::size_t>(mesh.triangles[3])], -1);
}

TEST(NumberOrder2, PiecesShareTheMiddlesOfTheCutBetweenThem) {
  Wall wall;
  wall.model.faces.push_back(wall.model.faces[0]);
  for (Edge& edge : wall.model.edges) edge.faces = {0, 1};
  RegionMesh low, high;
  wall.lay(low, {0, 1, 4, 5}, {{0, 1, 2, 3}});
  wall.lay(high, {5, 4, 2, 3}, {{0, 1, 2, 3}});
  wall.cuts = {{0, 4, 5, nullptr, {}, {}}};
  OrderTwoMesh apart = wall.raised({&low, &high});  // faces 0 and 1: the cut is face 0's
  EXPECT_NE(apart.mesh.quads[6], apart.mesh.quads[9 + 4]);
  EXPECT_EQ(apart.sides[0].border_cut[2], 0);
  EXPECT_EQ(apart.cut_node[0], apart.mesh.quads[6]);
  EXPECT_EQ(apart.first_inside, apart.cut_node[0] + 1);
}

TEST(NumberSides, EachOnceInTheOrderOfFirstUse) {
  Wall wall;
  PartSides sides = number_sides(wall.mesh);
  ASSERT_EQ(sides.inside.size(), 1u);
  EXPECT_EQ(sides.inside[0], (std::array<int, 2>{2, 3}));
  EXPECT_EQ(sides.border.size(), 6u);
  EXPECT_EQ(sides.of_element[0], (std::array<int, 4>{-1, -2, 0, -3}));
  EXPECT_EQ(sides.of_element[1], (std::array<int, 4>{0, -4, -5, -6}));
}

TEST(NumberOrder2, AnEmptyMeshStaysEmpty) {
  OrderTwoMesh raised = number_order_2({}, {{}, {}, {}, Cuts({}, {}), {}, 1});
  EXPECT_EQ(raised.mesh.order, 2);
  EXPECT_TRUE(raised.mesh.nodes.empty());
}

}  // namespace
}  // namespace paver
