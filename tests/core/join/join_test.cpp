#include "join/join.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "support/alone.h"
#include "support/boundary_use.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Two unit squares side by side in z = 0, the second one reversed; edge 1 is common.
struct Pair {
  Model model;
  EdgeNodes edges;
  std::array<Region, 2> regions;
};

Pair two_squares() {
  Pair pair;
  pair.regions[0].face = 0, pair.regions[1].face = 1;
  fake::Builder builder;
  for (Vec3 x : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}, Vec3{2, 0, 0}, Vec3{2, 1, 0}})
    builder.vertex(x);
  builder.line(0, 1), builder.line(1, 2), builder.line(2, 3), builder.line(3, 0);
  builder.line(1, 4), builder.line(4, 5), builder.line(5, 2);
  auto up = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  auto down = std::make_shared<fake::Plane>(Vec3{}, Vec3{0, 1, 0}, Vec3{1, 0, 0});  // normal -z, used reversed
  builder.face(up, 1, {{builder.use(0), builder.use(1), builder.use(2), builder.use(3)}});
  builder.face(down, 1, {{builder.use(1), builder.use(6, true), builder.use(5, true), builder.use(4, true)}});
  pair.model = builder.take();
  pair.model.faces[1].is_reversed = true;
  SizeField size;
  size.h = 0.5;
  size.faces.assign(2, FaceSize(0.5));
  Progress progress;
  test::Alone alone(progress);
  pair.edges = divide_edges(pair.model, size, {std::vector<int>(7, 2), {}}, alone);
  return pair;
}

int boundary_node(const EdgeNodes& edges, Vec3 x) {
  for (std::size_t i = 0; i < edges.nodes.size(); ++i)
    if (norm(edges.nodes[i] - x) < 1e-12) return static_cast<int>(i);
  return -1;
}

/// Four quads over the square at `at`, counter-clockwise in the chart, which is (y, x) where `is_turned`.
RegionMesh four_quads(const EdgeNodes& edges, Vec3 at, bool is_turned) {
  RegionMesh mesh;
  mesh.add_node({9, 9}, {9, 9, 9}, {}, {}, 1);  // belongs to no element
  std::map<std::pair<int, int>, int> number;
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i <= 2; ++i) {
      Vec2 p{0.5 * i, 0.5 * j};
      Vec3 x = at + (is_turned ? Vec3{p.y, p.x, 0} : Vec3{p.x, p.y, 0});
      number[{i, j}] = mesh.add_node(p, x, {}, {}, 0.5);
      mesh.global.back() = boundary_node(edges, x);
    }
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i)
      mesh.add_element({number[{i, j}], number[{i + 1, j}], number[{i + 1, j + 1}], number[{i, j + 1}]});
  return mesh;
}

TEST(JoinRegions, NeighboursShareTheNodesOfTheirEdge) {
  Pair pair = two_squares();
  RegionMesh left = four_quads(pair.edges, {0, 0, 0}, false), right = four_quads(pair.edges, {1, 0, 0}, true);
  JoinedMesh joined = join_regions(pair.model, pair.edges, test::all_of(pair.edges),
                                   {{&pair.regions[0], &left}, {&pair.regions[1], &right}});
  const SurfaceMesh& mesh = joined.mesh;
  EXPECT_EQ(mesh.nodes.size(), 15u);  // 6 vertices, 7 on edges, 2 inside
  EXPECT_EQ(mesh.node_edge.size(), 15u);
  EXPECT_EQ(mesh.node_target.size(), 15u);
  ASSERT_EQ(mesh.quad_count(), 8u);
  EXPECT_EQ(mesh.quad_face, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t q = 0; q < 8; ++q)
    for (std::size_t k = 0; k < 4; ++k) ++uses[{mesh.quads[4 * q + k], mesh.quads[4 * q + (k + 1) % 4]}];
  int interior = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_EQ(count, 1);  // the same direction twice would be two elements on one side
    interior += uses.contains({edge.second, edge.first});
  }
  EXPECT_EQ(interior, 2 * 10);
}

TEST(JoinRegions, ElementsRunCounterClockwiseAgainstTheOutwardNormal) {
  Pair pair = two_squares();
  RegionMesh left = four_quads(pair.edges, {0, 0, 0}, false), right = four_quads(pair.edges, {1, 0, 0}, true);
  SurfaceMesh mesh = join_regions(pair.model, pair.edges, test::all_of(pair.edges),
                                  {{&pair.regions[0], &left}, {&pair.regions[1], &right}})
                         .mesh;
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) {
    auto x = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(mesh.quads[4 * q + k])]; };
    EXPECT_GT(cross(x(1) - x(0), x(3) - x(0)).z, 0) << q;
  }
}

TEST(JoinRegions, ThreadsMakeNoDifference) {
  Pair pair = two_squares();
  RegionMesh left = four_quads(pair.edges, {0, 0, 0}, false), right = four_quads(pair.edges, {1, 0, 0}, true);
  const std::vector<MeshPart> parts{{&pair.regions[0], &left}, {&pair.regions[1], &right}};
  const BoundaryUse use = test::all_of(pair.edges);
  const JoinedMesh one = join_regions(pair.model, pair.edges, use, parts, {.threads = 1}),
                   two = join_regions(pair.model, pair.edges, use, parts, {.order = 2, .threads = 2});
  EXPECT_EQ(one.mesh.quads, two.mesh.quads);
  EXPECT_EQ(one.mesh.node_target, two.mesh.node_target);
  EXPECT_EQ(one.node_of, two.node_of);
}

TEST(JoinRegions, LinesRunAlongEveryEdge) {
  Pair pair = two_squares();
  SurfaceMesh mesh = join_regions(pair.model, pair.edges, test::all_of(pair.edges), {}).mesh;
  ASSERT_EQ(mesh.line_edge, (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6}));
  for (std::size_t e = 0; e < 7; ++e) {
    EXPECT_EQ(mesh.lines[4 * e], pair.model.edges[e].start);
    EXPECT_EQ(mesh.lines[4 * e + 1], mesh.lines[4 * e + 2]);
    EXPECT_EQ(mesh.lines[4 * e + 3], pair.model.edges[e].end);
  }
}

TEST(JoinRegions, WhatNoFaceUsesIsLeftOut) {
  Pair pair = two_squares();
  RegionMesh right = four_quads(pair.edges, {1, 0, 0}, true);
  BoundaryUse use{std::vector<char>(pair.edges.nodes.size(), 0), {0, 1, 0, 0, 1, 1, 1}};
  for (int global : right.global)
    if (global >= 0) use.nodes[static_cast<std::size_t>(global)] = 1;
  JoinedMesh joined =
      join_regions(pair.model, pair.edges, use, {{&pair.regions[0], nullptr}, {&pair.regions[1], &right}});
  const SurfaceMesh& mesh = joined.mesh;
  EXPECT_EQ(joined.boundary_nodes, 8);
  EXPECT_EQ(mesh.nodes.size(), 9u);
  EXPECT_EQ(mesh.node_edge.size(), 9u);
  EXPECT_EQ(mesh.node_target.size(), 9u);
  EXPECT_EQ(mesh.line_edge, (std::vector<int>{1, 1, 4, 4, 5, 5, 6, 6}));
  std::vector<char> is_used(9, 0);
  for (int node : mesh.quads) is_used.at(static_cast<std::size_t>(node)) = 1;
  EXPECT_EQ(is_used, std::vector<char>(9, 1));
  for (int node : mesh.lines) EXPECT_GE(mesh.nodes.at(static_cast<std::size_t>(node)).x, 1);
  for (std::size_t i = 1; i < 10; ++i)
    EXPECT_EQ(norm(mesh.nodes[static_cast<std::size_t>(joined.node_of[1][i])] - right.x[i]), 0) << i;
}

TEST(JoinRegions, FailedRegionsLeaveTheOthersWhole) {
  Pair pair = two_squares();
  RegionMesh right = four_quads(pair.edges, {1, 0, 0}, true);
  JoinedMesh joined = join_regions(pair.model, pair.edges, test::all_of(pair.edges),
                                   {{&pair.regions[0], nullptr}, {&pair.regions[1], &right}});
  EXPECT_EQ(joined.mesh.quad_face, (std::vector<int>{1, 1, 1, 1}));
  ASSERT_EQ(joined.node_of.size(), 2u);
  EXPECT_TRUE(joined.node_of[0].empty());
  ASSERT_EQ(joined.node_of[1].size(), 10u);
  EXPECT_EQ(joined.node_of[1][0], -1);
  for (std::size_t i = 1; i < 10; ++i)
    EXPECT_EQ(norm(joined.mesh.nodes[static_cast<std::size_t>(joined.node_of[1][i])] - right.x[i]), 0) << i;
}

TEST(JoinRegions, DeadElementsAndTrianglesAreTakenAsTheyAre) {
  Pair pair = two_squares();
  RegionMesh left = four_quads(pair.edges, {0, 0, 0}, false);
  std::array<int, 4> v = left.elements[0].v;
  left.remove_element(0);
  left.add_element({v[0], v[1], v[2], -1});
  left.add_element({v[0], v[2], v[3], -1});
  SurfaceMesh mesh = join_regions(pair.model, pair.edges, test::all_of(pair.edges), {{&pair.regions[0], &left}}).mesh;
  EXPECT_EQ(mesh.quad_count(), 3u);
  EXPECT_EQ(mesh.triangle_face, (std::vector<int>{0, 0}));
}

TEST(JoinRegions, AnElementThatWouldUseANodeTwiceNamesItsFace) {
  Pair pair = two_squares();
  RegionMesh left = four_quads(pair.edges, {0, 0, 0}, false);
  left.global[2] = left.global[1];  // as when both sides of a periodic edge end in one element
  try {
    join_regions(pair.model, pair.edges, test::all_of(pair.edges), {{&pair.regions[0], &left}});
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::face_failed);
    EXPECT_EQ(error.where().face, 0);
    EXPECT_TRUE(error.where().point);
  }
}

}  // namespace
}  // namespace paver
