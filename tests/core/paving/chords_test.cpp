#include "paving/cleanup/chords.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/predicates.h"
#include "support/planar_region.h"

namespace paver {
namespace {

/// A slot whose round end, nodes 0 to 5, is one B-rep edge; four quads in a row, with (0 5) and (1 4) across the end:
///
///    7---6---5-_4
///    |   |   |   |3
///    |   |   | _ |2
///    8---9---0- 1
struct Slot {
  explicit Slot(bool is_one_edge) : region(make_region(is_one_edge)), front(region, mesh) {
    EXPECT_FALSE(front.start());
    mesh.add_element({8, 9, 6, 7});
    mesh.add_element({9, 0, 5, 6});
    mesh.add_element({0, 1, 4, 5});
    mesh.add_element({1, 2, 3, 4});
  }
  static Region make_region(bool is_one_edge) {
    std::vector<Vec2> loop;
    for (int i = 0; i <= 5; ++i) {
      double angle = std::numbers::pi * (i / 5.0 - 0.5);
      loop.push_back({std::cos(angle), std::sin(angle)});
    }
    for (Vec2 p : {Vec2{-1, 1}, Vec2{-2, 1}, Vec2{-2, -1}, Vec2{-1, -1}}) loop.push_back(p);
    Region region = test::planar_region({loop}, 1);
    for (int i = 0; i < 10; ++i) region.loops[0][static_cast<std::size_t>(i)].edge = is_one_edge && i < 5 ? 0 : 1 + i;
    return region;
  }
  bool has_side(int a, int b) const {
    for (const Element& e : mesh.elements)
      if (e.is_alive() && e.corner_of(a) >= 0 && e.corner_of(b) >= 0 && (e.after(a) == b || e.after(b) == a))
        return true;
    return false;
  }
  Region region;
  RegionMesh mesh;
  Front front;
};

TEST(RemoveChords, ARoundEndIsFilledWithoutSidesAcrossIt) {
  Slot slot(true);
  double area = 0;
  EXPECT_GE(remove_chords(slot.front), 2);
  for (int a = 0; a <= 5; ++a)
    for (int b = a + 2; b <= 5; ++b) EXPECT_FALSE(slot.has_side(a, b)) << a << " " << b;
  for (const Element& e : slot.mesh.elements) {
    if (!e.is_alive()) continue;
    EXPECT_GT(scaled_jacobian(slot.mesh, e), 0.1);
    for (int i = 0, n = e.corners(); i < n; ++i) {
      Vec2 a = slot.mesh.p[e.v[i]], b = slot.mesh.p[e.v[(i + 1) % n]], c = slot.mesh.p[e.v[(i + 2) % n]];
      EXPECT_GT(orientation(a, b, c), 0);
      area += 0.5 * cross(a, b);
    }
  }
  EXPECT_NEAR(area, test::chart_area(slot.region), 1e-12);
}

TEST(RemoveChords, SidesBetweenDifferentEdgesStay) {
  Slot slot(false);
  EXPECT_EQ(remove_chords(slot.front), 0);
  EXPECT_EQ(slot.mesh.elements.size(), 4U);
  EXPECT_EQ(slot.mesh.node_count(), 10) << "no node is left over";
}

}  // namespace
}  // namespace paver
