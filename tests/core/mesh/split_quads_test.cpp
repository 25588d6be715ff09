#include "mesh/split_quads.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

RegionMesh flat_mesh(const std::vector<Vec2>& points) {
  RegionMesh mesh;
  for (Vec2 p : points) mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  return mesh;
}

std::vector<Element> alive(const RegionMesh& mesh) {
  std::vector<Element> result;
  for (const Element& e : mesh.elements)
    if (e.is_alive()) result.push_back(e);
  return result;
}

double area(const RegionMesh& mesh) {
  double sum = 0;
  for (const Element& e : alive(mesh))
    for (int i = 0; i < e.corners(); ++i) sum += 0.5 * cross(mesh.p[e.v[i]], mesh.p[e.v[(i + 1) % e.corners()]]);
  return sum;
}

double worst(const RegionMesh& mesh) {
  double least = 1;
  for (const Element& e : alive(mesh)) least = std::min(least, scaled_jacobian(mesh, e));
  return least;
}

bool has_side(const RegionMesh& mesh, int a, int b) {
  for (const Element& e : alive(mesh))
    for (int i = 0; i < e.corners(); ++i) {
      int from = e.v[i], to = e.v[(i + 1) % e.corners()];
      if ((from == a && to == b) || (from == b && to == a)) return true;
    }
  return false;
}

// Both would best be cut from 0 to 2.
TEST(SplitQuads, OfTwoQuadsThatShareTwoSidesOneIsCutAcrossThese) {
  RegionMesh mesh = flat_mesh({{0, 0}, {2, -1}, {4, 0}, {2, 0.1}, {2, 3}});
  mesh.add_element({0, 1, 2, 3});
  mesh.add_element({0, 3, 2, 4});
  split_all_quads(mesh);
  ASSERT_EQ(alive(mesh).size(), 4U);
  EXPECT_TRUE(has_side(mesh, 1, 3) || has_side(mesh, 3, 4));
  EXPECT_DOUBLE_EQ(area(mesh), 8);
}

TEST(SplitQuads, EveryQuadIsSplitAlongItsBetterDiagonal) {
  RegionMesh mesh = flat_mesh({{0, 0}, {1, 0}, {1.2, 1}, {0, 1}, {2, 0}, {2.2, 1}, {-1, 0.5}});
  mesh.add_element({0, 1, 2, 3});
  mesh.add_element({1, 4, 5, 2});
  mesh.add_element({0, 3, 6, -1});
  const double before = area(mesh);
  split_all_quads(mesh);
  EXPECT_EQ(alive(mesh).size(), 5U);
  for (const Element& e : alive(mesh)) EXPECT_EQ(e.corners(), 3);
  EXPECT_TRUE(has_side(mesh, 1, 3));
  EXPECT_TRUE(has_side(mesh, 4, 2));
  EXPECT_DOUBLE_EQ(area(mesh), before);
}

TEST(SplitQuads, OfEquallyGoodDiagonalsTheOneAtTheFirstNodeIsTaken) {
  for (int turn = 0; turn < 4; ++turn) {
    RegionMesh mesh = flat_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    mesh.add_element({turn, (turn + 1) % 4, (turn + 2) % 4, (turn + 3) % 4});
    split_all_quads(mesh);
    EXPECT_TRUE(has_side(mesh, 0, 2)) << turn;
  }
}

TEST(SplitQuads, AQuadWithAReflexCornerIsCutThere) {
  RegionMesh mesh = flat_mesh({{0, 0}, {1, 0.2}, {2, 0}, {1, 1}});
  mesh.add_element({0, 1, 2, 3});
  ASSERT_LT(worst(mesh), 0);
  split_all_quads(mesh);
  EXPECT_TRUE(has_side(mesh, 1, 3));
}

TEST(SplitQuads, AQuadThatIsNotPositiveOnEitherDiagonalIsNotSplit) {
  RegionMesh mesh = flat_mesh({{0, 0}, {1, 1}, {1, 0}, {0, 1}});  // crossed
  mesh.add_element({0, 1, 2, 3});
  split_all_quads(mesh);
  EXPECT_EQ(alive(mesh).size(), 1U);
  RegionMesh square = flat_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  square.add_element({0, 1, 2, 3});
  split_all_quads(square);
  EXPECT_EQ(alive(square).size(), 2U);
}

}  // namespace
}  // namespace paver
