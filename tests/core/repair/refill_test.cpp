// Divisions of small outlines, with values that are made up or those of flat elements.
#include "repair/edits/refill.h"

#include <gtest/gtest.h>

#include <numeric>

#include "repair/edits/patch.h"
#include "support/planar_region.h"

namespace paver {
namespace {

constexpr ElementKinds both{}, only_quads{true, false}, only_triangles{false, true};
const auto none_taken = [](int, int) { return false; };

std::vector<int> outline_of_size(int n) {
  std::vector<int> outline(static_cast<std::size_t>(n));
  std::iota(outline.begin(), outline.end(), 0);
  return outline;
}

/// Nodes on a circle in the plane, with the scaled Jacobian as value; -1 where an element is not positive.
struct Circle {
  explicit Circle(int n) {
    for (Vec2 p : test::circle({}, 1, n)) mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  }
  double value(const Corners& v) const { return positive_jacobian(mesh, v); }
  Filling fill(ElementKinds kinds) const {
    return fill_outline(
        outline_of_size(mesh.node_count()), kinds, [&](const Corners& v, double) { return value(v); }, none_taken);
  }
  RegionMesh mesh;
};

TEST(FillOutline, TakesQuadsWhereTheyAreGoodEnough) {
  for (int n : {4, 6, 8}) {
    const Filling filling = Circle(n).fill(both);
    EXPECT_EQ(filling.triangles, 0) << n;
    EXPECT_EQ(filling.elements.size(), static_cast<std::size_t>(n) / 2 - 1);
    EXPECT_GT(filling.worst, 0.2);
  }
}

TEST(FillOutline, TakesATriangleForAnOddOutline) {
  const Filling filling = Circle(7).fill(both);
  EXPECT_EQ(filling.triangles, 1);
  EXPECT_EQ(filling.elements.size(), 3U);
  EXPECT_TRUE(Circle(7).fill(only_quads).elements.empty());
}

TEST(FillOutline, MakesOnlyTheKindsThatAreAskedFor) {
  EXPECT_EQ(Circle(6).fill(only_triangles).triangles, 4);
  EXPECT_EQ(Circle(6).fill(only_quads).triangles, 0);
}

TEST(FillOutline, NeverUsesAnElementWithoutValue) {
  // Everything with nodes 0 and 2 together is worthless.
  auto value = [](const Corners& v, double) {
    const bool has_0 = std::count(v.begin(), v.end(), 0) > 0, has_2 = std::count(v.begin(), v.end(), 2) > 0;
    return has_0 && has_2 ? -1.0 : 1.0;
  };
  const Filling filling = fill_outline(outline_of_size(5), both, value, none_taken);
  ASSERT_FALSE(filling.elements.empty());
  for (const Corners& v : filling.elements) EXPECT_GT(value(v, 0), 0);
  auto worthless = [](const Corners&, double) { return 0.0; };
  EXPECT_TRUE(fill_outline(outline_of_size(3), both, worthless, none_taken).elements.empty());
}

TEST(FillOutline, LeavesSidesThatOthersHave) {
  const Filling filling = fill_outline(
      outline_of_size(4), only_triangles, [](const Corners&, double) { return 1.0; },
      [](int a, int b) { return a + b == 2; });  // 0 and 2
  ASSERT_EQ(filling.elements.size(), 2U);
  for (const Corners& v : filling.elements)
    EXPECT_FALSE(std::count(v.begin(), v.end(), 0) && std::count(v.begin(), v.end(), 2));
}

TEST(FillOutline, RefusesOutlinesThatAreTooLong) { EXPECT_TRUE(Circle(most_outline + 1).fill(both).elements.empty()); }

TEST(FillOutline, NeedsNoExactValuesAtTheFloorAndBelow) {
  for (int n : {5, 6, 7, 8}) {
    const Circle circle(n);
    const Filling exact = circle.fill(both);
    const Filling rough = fill_outline(
        outline_of_size(n), both,
        [&](const Corners& v, double floor) {
          const double value = circle.value(v);
          return value <= floor ? std::min(floor, 0.0) - 1 : value;
        },
        none_taken);
    EXPECT_EQ(rough.elements, exact.elements) << n;
    EXPECT_EQ(rough.worst, exact.worst) << n;
  }
}

TEST(FillAbout, JoinsTheCentreWithQuadsByTurns) {
  Circle circle(6);
  const int centre = circle.mesh.add_node({}, {}, {1, 0, 0}, {0, 1, 0}, 1);
  auto value = [&](const Corners& v, double) { return circle.value(v); };
  const Filling quads = fill_about(centre, outline_of_size(6), both, value);
  EXPECT_EQ(quads.elements.size(), 3U);
  EXPECT_EQ(quads.triangles, 0);
  EXPECT_EQ(fill_about(centre, outline_of_size(6), only_triangles, value).triangles, 6);
  EXPECT_EQ(fill_about(centre, outline_of_size(5), only_quads, value).elements.size(), 0U);
}

/// Three by two quads, nodes in rows of four.
RegionMesh grid() {
  RegionMesh mesh;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) mesh.add_node({1.0 * i, 1.0 * j}, {1.0 * i, 1.0 * j, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i) mesh.add_element({4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4});
  return mesh;
}

TEST(Patch, KnowsWhatLiesAcrossAndAbout) {
  const RegionMesh mesh = grid();
  EXPECT_EQ(mesh.across(1, 5), 1);
  EXPECT_EQ(mesh.across(5, 1), 0);
  EXPECT_EQ(mesh.across(0, 1), -1);
  EXPECT_EQ(neighbours_of(mesh, 1), (ElementSet{2, 4, 0}));
  EXPECT_EQ(ring_about(mesh, 0), (ElementSet{0, 1, 3, 4}));
}

TEST(Patch, HasOneLoopAndWhatLiesInside) {
  const RegionMesh mesh = grid();
  const PatchOutline whole = outline_of(mesh, {0, 1, 3, 4}, 10);
  EXPECT_EQ(whole.loop.size(), 8U);
  EXPECT_EQ(whole.inside, std::vector<int>{5});
  EXPECT_TRUE(outline_of(mesh, {0, 2}, 10).loop.empty());  // apart
  EXPECT_TRUE(outline_of(mesh, {0, 4}, 10).loop.empty());  // at one node
  EXPECT_TRUE(outline_of(mesh, {0, 1, 3, 4}, 7).loop.empty());
  EXPECT_TRUE(is_side_outside(mesh, {0}, 1, 5));
  EXPECT_FALSE(is_side_outside(mesh, {0, 1}, 1, 5));
}

}  // namespace
}  // namespace paver
