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
}  // namespace paver
