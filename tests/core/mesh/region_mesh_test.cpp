#include "mesh/region_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace paver {
namespace {

/// A grid of n x n nodes with unit spacing, quads between.
RegionMesh grid(int n) {
  RegionMesh mesh;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      double x = i, y = j;
      mesh.add_node({x, y}, {x, y, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    }
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) mesh.add_element({i + n * j, i + 1 + n * j, i + 1 + n * (j + 1), i + n * (j + 1)});
  return mesh;
}

std::set<int> star_of(const RegionMesh& mesh, int node) { return {mesh.star[node].begin(), mesh.star[node].end()}; }

/// Stars must say the same as the elements.
void expect_consistent(const RegionMesh& mesh) {
  std::vector<std::set<int>> expected(static_cast<std::size_t>(mesh.node_count()));
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (int v : mesh.elements[e].v)
      if (v >= 0) expected[static_cast<std::size_t>(v)].insert(static_cast<int>(e));
  for (int i = 0; i < mesh.node_count(); ++i) EXPECT_EQ(star_of(mesh, i), expected[static_cast<std::size_t>(i)]) << i;
}

TEST(Star, HoldsAnyNumberOfElements) {
  std::mt19937 random(4);
  Star star;
  std::multiset<int> expected;
  for (int i = 0; i < 5000; ++i) {
    bool is_growing = (i / 40) % 2 == 0;  // up to some 30 and down again, across the limit of what is kept in place
    if (is_growing || expected.empty()) {
      star.add(i);
      expected.insert(i);
    } else {
      auto at = std::next(expected.begin(), static_cast<long>(random() % expected.size()));
      star.remove(*at);
      star.remove(-7);  // is not in it
      expected.erase(at);
    }
    ASSERT_EQ(std::multiset<int>(star.begin(), star.end()), expected) << i;
  }
}

TEST(RegionMesh, KnowsNeighboursInAnElement) {
  Element quad{{7, 3, 9, 4}}, triangle{{7, 3, 9, -1}};
  EXPECT_EQ(quad.corners(), 4);
  EXPECT_EQ(triangle.corners(), 3);
  EXPECT_EQ(quad.after(4), 7);
  EXPECT_EQ(quad.before(7), 4);
  EXPECT_EQ(triangle.after(9), 7);
  EXPECT_EQ(triangle.before(7), 9);
  EXPECT_EQ(quad.corner_of(8), -1);
  EXPECT_FALSE(Element{}.is_alive());
}

TEST(RegionMesh, EditsKeepStarsInStep) {
  RegionMesh mesh = grid(4);
  mesh.replace_node(4, 5, 0);
  EXPECT_EQ(mesh.elements[4].v[0], 0);
  expect_consistent(mesh);
  mesh.remove_element(4);
  int e = mesh.add_element({5, 6, 10, -1});
  EXPECT_EQ(mesh.elements[static_cast<std::size_t>(e)].corners(), 3);
  expect_consistent(mesh);
  int node = mesh.add_node({9, 9}, {9, 9, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  EXPECT_EQ(node, 16);
  mesh.drop_last_node();
  EXPECT_EQ(mesh.node_count(), 16);
  expect_consistent(mesh);
}

TEST(RegionMesh, PullBackSolvesForTheChartStep) {
  RegionMesh mesh;
  Vec3 xp{2, 1, 0}, xq{0.5, 1, 3};
  mesh.add_node({0, 0}, {0, 0, 0}, xp, xq, 1);
  Vec2 step =
      mesh.pull_back(0, {0.3 * xp + -0.8 * xq + 5 * cross(xp, xq), {}});  // what stands off the plane is dropped
  EXPECT_NEAR(step.x, 0.3, 1e-14);
  EXPECT_NEAR(step.y, -0.8, 1e-14);
  mesh.add_node({0, 0}, {0, 0, 0}, xp, xp, 1);
  EXPECT_EQ(mesh.pull_back(1, {xp, {}}), (Vec2{0, 0}));
}

double jacobian_of(std::vector<Vec3> corners) {
  RegionMesh mesh;
  std::array<int, 4> v{-1, -1, -1, -1};
  for (std::size_t i = 0; i < corners.size(); ++i)
    v[i] = mesh.add_node({corners[i].x, corners[i].y}, corners[i], {1, 0, 0}, {0, 1, 0}, 1);
  return scaled_jacobian(mesh, {v});
}

TEST(RegionMesh, ScaledJacobianHasKnownValues) {
  EXPECT_NEAR(jacobian_of({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}), 1, 1e-15);
  EXPECT_NEAR(jacobian_of({{0, 0, 0}, {1, 0, 0}, {1.5, std::sqrt(3) / 2, 0}, {0.5, std::sqrt(3) / 2, 0}}),
              std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(jacobian_of({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(3) / 2, 0}}), 1, 1e-15);
  EXPECT_NEAR(jacobian_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), std::sqrt(0.5) * 2 / std::sqrt(3), 1e-15);
  EXPECT_NEAR(jacobian_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}), 0, 1e-15);
  EXPECT_LT(jacobian_of({{0, 0, 0}, {2, 0, 0}, {0.2, 0.2, 0}, {0, 2, 0}}), 0);  // concave
  EXPECT_EQ(jacobian_of({{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}}), -1);     // a side without length
  double flat = jacobian_of({{0, 0, 0}, {1, 0, 0}, {1.2, 1, 0}, {0, 1, 0}});
  EXPECT_NEAR(jacobian_of({{5, 7, 0}, {5, 7, -4}, {5, 11, -4.8}, {5, 11, 0}}), flat, 1e-14);  // turned and scaled
}

TEST(ScaledJacobian, IsToldFromABoundWithoutRoots) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.6, 0.6);
  for (int i = 0; i < 2000; ++i) {
    RegionMesh mesh;
    for (Vec2 p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 1}, Vec2{0, 1}})
      mesh.add_node(p, {p.x + jitter(random), p.y + jitter(random), jitter(random)}, {1, 0, 0}, {0, 1, 0}, 1);
    for (const Element& e : {Element{{0, 1, 2, 3}}, Element{{0, 1, 2, -1}}}) {
      double sj = scaled_jacobian(mesh, e);
      for (double bound : {0.2, 0.7, sj + 1e-9, sj - 1e-9})
        if (bound > 0) {
          EXPECT_EQ(has_jacobian(mesh, e, bound), sj >= bound);
        }
    }
  }
}

}  // namespace
}  // namespace paver
