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
    std::vector<LoopNode> loop = region.loops[0];
    lay_rounded_corners(region, mesh, loop, nodes, others);
    EXPECT_EQ(loop.size(), nodes.size());
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

// A wedge of 30 degrees, its two other corners rounded: the tip is filled like that of a wedge with sharp ones.
TEST(RoundedCorners, LeaveAcuteCornersWhereTheyAre) {
  const double angle = pi / 6, radius = 0.05;
  const int n = 12;
  const Vec2 along{std::cos(angle), std::sin(angle)}, right{12, 0}, far = 12.0 * along;
  auto rounded = [&](Vec2 corner, Vec2 before, Vec2 after) {
    const Vec2 in = (1 / norm(corner - before)) * (corner - before),
               out = (1 / norm(after - corner)) * (after - corner);
    return std::vector{corner - radius * in, corner + 0.3 * radius * (out - in), corner + radius * out};
  };
  std::vector<Vec2> loop{{0, 0}};
  for (int i = 1; i < n; ++i) loop.push_back({1.0 * i, 0});
  for (Vec2 p : rounded(right, {}, far)) loop.push_back(p);
  for (int i = 1; i < 6; ++i) loop.push_back(right + i / 6.0 * (far - right));
  for (Vec2 p : rounded(far, right, {})) loop.push_back(p);
  for (int i = n - 1; i > 0; --i) loop.push_back(1.0 * i * along);
  Region region = test::planar_region({loop}, 1);
  for (LoopNode& node : region.loops[0]) node.angle = pi;
  region.loops[0][0].angle = angle;
  const PavedRegion paved = pave_region(region, Progress());
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  EXPECT_EQ(paved.mesh.triangle_count(), 2 * 2) << "of the rounded corners";
  const int tip = find_loop_nodes(region, paved.mesh)[0][0];
  ASSERT_EQ(paved.mesh.star[tip].size(), 1);
  EXPECT_EQ(paved.mesh.elements[*paved.mesh.star[tip].begin()].corners(), 4);
}

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
