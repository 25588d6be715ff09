// Single quads on facets of small regions.
#include <gtest/gtest.h>

#include "paving/rows/row.h"
#include "support/planar_region.h"

namespace paver {
namespace {

/// The quad laid on the facet from node 0 to node 1 of the polygon, its left side the facet before, its right side
/// wished one length upwards.
Element quad_beside_left_side(const std::vector<Vec2>& polygon, RegionMesh& mesh) {
  const Region region = test::planar_region({polygon}, 1);
  Front front(region, mesh);
  EXPECT_FALSE(front.start());
  const Wish right{1, {Vec3{0, 1, 0}, {}}, 1, 1};
  std::vector<int> new_nodes;
  EXPECT_TRUE(lay_quad(front, 0, nullptr, &right, 1, new_nodes));
  return mesh.elements.back();
}

TEST(LayQuad, MakesASquareBesideAStraightSide) {
  RegionMesh mesh;
  const Element quad = quad_beside_left_side({{0, 0}, {1, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}}, mesh);
  EXPECT_NEAR(norm(mesh.p[quad.v[2]] - Vec2{1, 1}), 0, 1e-9);
}

// Connecting to the node behind it would make the side still longer, and those of all quads that follow.
TEST(LayQuad, GoesBesideALongSideThatLeansOverIt) {
  RegionMesh mesh;
  const Element quad = quad_beside_left_side({{0, 0}, {1, 0}, {6, 0}, {6.4, 3}, {3.4, 2.6}, {2.4, 2.4}}, mesh);
  const Vec2 side = mesh.p[quad.v[2]] - Vec2{1, 0};
  EXPECT_NEAR(norm(side), 1, 1e-9);
  EXPECT_NEAR(side.x, side.y, 1e-9);
}

}  // namespace
}  // namespace paver
