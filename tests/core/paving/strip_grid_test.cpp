// Narrow strips: nodes of the long sides face each other; everything else is left to paving.
#include "paving/strip_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "charts/chart.h"
#include "quality/metrics.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Length x width in the plane z = 0, so many intervals on the low, right, high and left side; nodes of the high side
/// are shifted.
Region strip(double length, double width, std::array<int, 4> counts, double shift = 0, double h = 1) {
  Region region;
  region.surface = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  region.chart = make_row_chart(*region.surface, {{0, 0}, {length, width}});
  region.size = FaceSize(h);
  region.h = h;
  region.area = length * width;
  const Vec2 corner[] = {{0, 0}, {length, 0}, {length, width}, {0, width}};
  std::vector<LoopNode>& loop = region.loops.emplace_back();
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < counts[side]; ++i) {
      const double t = static_cast<double>(i) / counts[side];
      Vec2 uv = (1 - t) * corner[side] + t * corner[(side + 1) % 4];
      if (side == 2 && i > 0) uv.x += shift;
      const int number = 100 + static_cast<int>(loop.size());
      loop.push_back({number, 0, region.chart->to_chart(uv), {uv.x, uv.y, 0}, h, i == 0 ? M_PI_2 : M_PI});
    }
  return region;
}

std::size_t quads(const RegionMesh& mesh) {
  std::size_t count = 0;
  for (const Element& e : mesh.elements) count += e.is_alive() && e.corners() == 4;
  return count;
}

TEST(StripGrid, NodesOfTheLongSidesFaceEachOther) {
  const auto mesh = lay_strip(strip(10, 0.1, {10, 1, 10, 1}));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->elements.size(), 10U);
  EXPECT_EQ(quads(*mesh), 10U);
  for (const Element& e : mesh->elements) EXPECT_NEAR(scaled_jacobian(*mesh, e), 1, 1e-9);
}

TEST(StripGrid, TheEndsSayHowManyRows) {
  const auto mesh = lay_strip(strip(10, 0.3, {10, 2, 10, 2}));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(quads(*mesh), 20U);
  EXPECT_EQ(mesh->node_count(), 33);
}

TEST(StripGrid, ItMayStandUpright) {
  const auto mesh = lay_strip(strip(0.1, 10, {1, 10, 1, 10}));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(quads(*mesh), 10U);
}

TEST(StripGrid, NodesOfTheLoopAreKept) {
  const Region region = strip(10, 0.1, {10, 1, 10, 1});
  const auto mesh = lay_strip(region);
  ASSERT_TRUE(mesh);
  for (const LoopNode& node : region.loops[0]) {
    const auto at = std::find(mesh->global.begin(), mesh->global.end(), node.global);
    ASSERT_NE(at, mesh->global.end());
    EXPECT_TRUE(mesh->is_fixed[static_cast<std::size_t>(at - mesh->global.begin())]);
  }
}

// Nodes of both of its sides along the periodic edge are the same.
TEST(StripGrid, AreTubesCutOpenThatHaveNodesEnoughRound) {
  auto tube = [](int round, int along) {
    Region region = strip(6, 20, {round, along, round, along});
    const auto first = static_cast<std::size_t>(round), n = static_cast<std::size_t>(along);
    std::vector<LoopNode>& loop = region.loops[0];
    for (std::size_t i = 0; i <= n; ++i) loop[(2 * (first + n) - i) % loop.size()].global = loop[first + i].global;
    region.own_area = region.area;
    return lay_strip(region);
  };
  for (int along : {4, 20}) {
    const auto mesh = tube(6, along);
    ASSERT_TRUE(mesh) << along;
    EXPECT_EQ(mesh->elements.size(), 6U * static_cast<unsigned>(along)) << along;
  }
  EXPECT_FALSE(tube(4, 20)) << "1.5 target lengths wide";
}

TEST(StripGrid, WideRegionsAreNone) { EXPECT_FALSE(lay_strip(strip(10, 2, {10, 2, 10, 2}))); }

TEST(StripGrid, SidesMustHaveEquallyMany) { EXPECT_FALSE(lay_strip(strip(10, 0.1, {10, 1, 9, 1}))); }

TEST(StripGrid, SkewedGridsAreLeftToPaving) { EXPECT_FALSE(lay_strip(strip(10, 0.1, {10, 1, 10, 1}, 0.45))); }

/// Square of side 2 with a round hole, so many nodes on both; those of the hole turned by `turn` intervals.
Region frame(int nodes, double turn, double h) {
  Region region;
  region.surface = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  region.chart = make_row_chart(*region.surface, {{-1, -1}, {1, 1}});
  region.size = FaceSize(h);
  region.h = h;
  region.area = 4 - fake::pi / 4;
  int number = 100;
  auto add = [&](std::vector<LoopNode>& loop, Vec2 uv, double angle) {
    loop.push_back({number++, 0, region.chart->to_chart(uv), {uv.x, uv.y, 0}, h, angle});
  };
  std::vector<LoopNode> outer, hole;
  const Vec2 corner[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < nodes / 4; ++i) {
      const double t = 4.0 * i / nodes;
      add(outer, (1 - t) * corner[side] + t * corner[(side + 1) % 4], i == 0 ? M_PI_2 : M_PI);
    }
  for (int i = 0; i < nodes; ++i) {
    const double angle = -2 * fake::pi * (i + turn) / nodes;
    add(hole, {0.5 * std::cos(angle), 0.5 * std::sin(angle)}, M_PI);
  }
  region.loops = {outer, hole};
  return region;
}

TEST(StripGrid, BetweenTwoLoopsItIsARing) {
  const auto mesh = lay_strip(frame(8, 0, 4));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(quads(*mesh), 8U);
  EXPECT_EQ(mesh->node_count(), 16);
  for (const Element& e : mesh->elements) EXPECT_GT(scaled_jacobian(*mesh, e), 0.7);
}

TEST(StripGrid, ARingMayBeginAnywhere) {
  Region region = frame(8, 0, 4);
  std::rotate(region.loops[1].begin(), region.loops[1].begin() + 3, region.loops[1].end());
  const auto mesh = lay_strip(region);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(quads(*mesh), 8U);
}

TEST(StripGrid, WideRingsAreNone) { EXPECT_FALSE(lay_strip(frame(8, 0, 0.5))); }

}  // namespace
}  // namespace paver
