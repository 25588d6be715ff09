// Sides inside that would be one mesh edge, as their ends on the boundary are one node.
#include "repair/mend_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "repair/shared_sides.h"
#include "support/fake_model.h"
#include "support/planar_region.h"

namespace paver {
namespace {

/// Four quads about a node, which is number 0; the first and the fifth of the eight about it are one node.
struct Wheel {
  Wheel() : region(test::planar_region({test::divided({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 1)}, 1)) {
    add({0.3, 0});
    for (int k = 0; k < 8; ++k) {
      add({std::cos(0.25 * fake::pi * k), std::sin(0.25 * fake::pi * k)});
      mesh.is_fixed.back() = 1, mesh.global.back() = k == 4 ? 0 : k;
    }
    for (int k = 1; k < 8; k += 2) mesh.add_element({0, k, k + 1, k == 7 ? 1 : k + 2});
    for (auto& loop : region.loops)
      for (LoopNode& node : loop) node.edge = -1;
  }
  void add(Vec2 p) { mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 1); }
  Mended mend(Elements elements) {
    const BoundarySides sides(region, edges);
    return mend_mesh({region, mesh, sides, 2}, kinds_of(elements), {}, mesh);
  }
  long alive() const {
    return std::count_if(mesh.elements.begin(), mesh.elements.end(), [](const Element& e) { return e.is_alive(); });
  }

  Region region;
  RegionMesh mesh;
  EdgeNodes edges;
};

TEST(MendMesh, FillsThePlaceOfTwinSidesAnew) {
  Wheel wheel;
  ASSERT_EQ(twin_sides(wheel.mesh).size(), 1u);
  const Mended mended = wheel.mend(Elements::quad_dominant);
  EXPECT_TRUE(twin_sides(wheel.mesh).empty());
  EXPECT_TRUE(mended.left.empty());
  EXPECT_EQ(mended.places.size(), 1u);
  EXPECT_EQ(wheel.mesh.node_count(), 9) << "none was needed";
  for (const Element& e : wheel.mesh.elements) EXPECT_TRUE(!e.is_alive() || is_positive(wheel.mesh, e));
  EXPECT_EQ(wheel.alive(), 4);
}

TEST(MendMesh, LeavesTwinsToOtherWaysWhereNoTriangleMayBe) {
  Wheel wheel;
  EXPECT_TRUE(wheel.mend(Elements::all_quad).places.empty());
  EXPECT_EQ(twin_sides(wheel.mesh).size(), 1u);
}

}  // namespace
}  // namespace paver
