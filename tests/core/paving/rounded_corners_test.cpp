#include "paving/closing/rounded_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "paving/pave_region.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

/// `columns` by `rows` squares, the corners rounded by two facets each, smooth like an arc.
Region plate(int columns, int rows, double radius, const std::vector<std::vector<Vec2>>& holes = {}) {
  const Vec2 corners[] = {{0, 0}, {1.0 * columns, 0}, {1.0 * columns, 1.0 * rows}, {0, 1.0 * rows}};
  std::vector<Vec2> loop;
  for (int k = 0; k < 4; ++k) {
    const Vec2 ahead = corners[(k + 1) % 4] - corners[k], back = corners[(k + 3) % 4] - corners[k],
               along = (1 / norm(ahead)) * ahead, before = (1 / norm(back)) * back;
    const Vec2 centre = corners[k] + radius * (along + before);
    for (double turn : {0.0, pi / 4, pi / 2})
      loop.push_back(centre - radius * (std::sin(turn) * before + std::cos(turn) * along));
    for (int i = 1, n = k % 2 == 0 ? columns : rows; i < n; ++i) loop.push_back(corners[k] + 1.0 * i * along);
  }
  std::vector<std::vector<Vec2>> loops{loop};
  loops.insert(loops.end(), holes.begin(), holes.end());
  Region region = test::planar_region(loops, 1);
  for (LoopNode& node : region.loops[0]) node.angle = pi;
  return region;
}

struct Laid {
  RegionMesh mesh;
  std::vector<int> nodes;

  explicit Laid(const Region& region) {
    for (const LoopNode& node : region.loops[0]) nodes.push_back(add_node(region, node, mesh));
    std::vector<Vec2> others = mesh.p;
    for (std::size_t l = 1; l < region.loops.size(); ++l)
      for (const LoopNode& node : region.loops[l]) others.push_back(node.p);
    lay_rounded_corners(region, mesh, region.loops[0], nodes, others);
  }
};

TEST(RoundedCorners, AreTakenOffTheLoop) {
  const Region region = plate(6, 4, 0.05);
  const Laid laid(region);
  EXPECT_EQ(laid.mesh.living_elements(), 4 * 4);
  EXPECT_EQ(laid.mesh.triangle_count(), 4 * 2);
  EXPECT_EQ(laid.nodes.size(), region.loops[0].size() - 4 * 2);
  for (const Element& e : laid.mesh.elements) EXPECT_TRUE(is_positive(laid.mesh, e));
}

TEST(RoundedCorners, GetAQuadWhereTheirMiddleIsACorner) {
  Region region = plate(6, 4, 0.05);
  for (LoopNode& node : region.loops[0]) node.angle = 0.75 * pi;
  const Laid laid(region);
  EXPECT_EQ(laid.mesh.living_elements(), 4 * 3);
  EXPECT_EQ(laid.mesh.triangle_count(), 0);
}

TEST(RoundedCorners, StayWhereTheirFacetsAreNotShort) { EXPECT_EQ(Laid(plate(6, 4, 0.4)).mesh.living_elements(), 0); }

TEST(RoundedCorners, StayWhereSomethingElseLies) {
  const Region region = plate(6, 4, 0.05, {test::reversed(test::circle({0.7, 0.7}, 0.2, 6))});
  EXPECT_EQ(Laid(region).mesh.living_elements(), 3 * 4);
}

TEST(RoundedCorners, StayBetweenSidesOfTwoFacets) { EXPECT_EQ(Laid(plate(6, 2, 0.05)).mesh.living_elements(), 0); }

TEST(RoundedCorners, LeaveAGrid) {
  for (double radius : {0.12, 0.06, 0.01}) {
    SCOPED_TRACE(radius);
    const Region region = plate(9, 6, radius);
    const PavedRegion paved = pave_region(region, Progress());
    EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
    EXPECT_EQ(paved.mesh.living_elements(), 9 * 6 + 4 * 3);
    double worst = 1;
    for (const Element& e : paved.mesh.elements)
      if (e.is_alive()) worst = std::min(worst, scaled_jacobian(paved.mesh, e));
    EXPECT_GT(worst, 0.6);
  }
}

}  // namespace
}  // namespace paver
