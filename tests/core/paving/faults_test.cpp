#include "paving/faults.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

/// One quad in space; all normals point up.
RegionMesh quad_of(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  RegionMesh mesh;
  for (Vec3 x : {a, b, c, d}) mesh.add_node({x.x, x.y}, x, {1, 0, 0}, {0, 1, 0}, 1);
  mesh.add_element({0, 1, 2, 3});
  return mesh;
}

TEST(Faults, ASquareHasNone) { EXPECT_EQ(count_faults(quad_of({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0})).sum(), 0); }

TEST(Faults, AFlatCornerCounts) {
  Faults faults = count_faults(quad_of({0, 0, 0}, {1, 0, 0}, {2, 0.001, 0}, {0, 1, 0}));
  EXPECT_EQ(faults.flat, 1);
  EXPECT_EQ(faults.off_surface, 0);
}

TEST(Faults, AnElementTurnedOverIsOffTheSurface) {
  Faults faults = count_faults(quad_of({0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}));
  EXPECT_EQ(faults.off_surface, 1);
}

}  // namespace
TEST(FreeJacobian, LeavesOutCornersThatTheBoundaryHasSo) {
  Region region;
  RegionMesh mesh;
  auto add = [&](double x, double y) { return mesh.add_node({x, y}, {x, y, 0}, {1, 0, 0}, {0, 1, 0}, 1); };
  const int tip = add(0, 0), a = add(2, 0), b = add(2, 0.3);
  const Element triangle{{tip, a, b, -1}};
  mesh.add_element(triangle.v);
  const double whole = scaled_jacobian(mesh, triangle);
  EXPECT_LT(whole, 0.2);
  EXPECT_EQ(free_jacobian(region, mesh, triangle), whole);  // a free node may go elsewhere
  mesh.is_fixed[tip] = 1;
  EXPECT_GT(free_jacobian(region, mesh, triangle), 0.9);
  mesh.add_element({tip, b, add(0, 1), -1});  // two share the corner: other connections leave it to one
  EXPECT_EQ(free_jacobian(region, mesh, triangle), whole);
  region.fans.emplace_back().is_apex = true;
  mesh.global[tip] = region.fans[0].centre.global = 7;
  EXPECT_GT(free_jacobian(region, mesh, triangle), 0.9);  // those about an apex are as narrow as the surface turns
}

TEST(FreeJacobian, TakesABoundarysStraightNodeWithOneElementForPoor) {
  Region region;
  RegionMesh mesh;
  const std::vector<Vec2> corners{{0, 0}, {1, 0}, {0.5, 0.5}, {0, 1}};
  for (Vec2 p : corners) mesh.is_fixed[mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 1)] = 1;
  const Element quad{{0, 1, 2, 3}};
  mesh.add_element(quad.v);
  EXPECT_LT(free_jacobian(region, mesh, quad), 1e-9);  // two elements would do better there
}

}  // namespace paver
