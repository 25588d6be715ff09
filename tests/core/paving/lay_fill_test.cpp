// Regions of a structured layout: the loop's nodes kept, one quad per cell, nothing where cells fold.
#include "paving/lay_fill.h"

#include <gtest/gtest.h>

#include <map>

#include "structured/closed_layout.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// A block of 6 x 4 on the plane z = 0, its right half filled; `shift` of its last coarse place.
Region half(Vec2 shift, bool is_clockwise) {
  Region region;
  region.surface = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  region.chart = make_plain_chart();
  region.size = FaceSize(1);
  auto block = std::make_shared<MappedBlock>();
  block->chart = region.chart;
  block->fine = {6, 4};
  block->coarse.at = {{0, 0}, {6, 0}, {0, 4}, Vec2{6, 4} + shift};
  if (is_clockwise)
    std::swap(block->coarse.at[0], block->coarse.at[1]), std::swap(block->coarse.at[2], block->coarse.at[3]);
  block->is_clockwise = is_clockwise;
  region.fill = MappedFill{block, {3, 0}, {6, 4}};
  std::vector<LoopNode>& loop = region.loops.emplace_back();
  for (const auto& [i, j] : region.fill->outline()) {
    const Vec2 p = block->place(i, j);
    loop.push_back({100 + static_cast<int>(loop.size()), -1, p, {p.x, p.y, 1e-3}, 0.5, -1});
  }
  return region;
}

TEST(LayFill, GivesAQuadPerCellAndKeepsTheLoop) {
  for (bool is_clockwise : {false, true}) {
    const Region region = half({0, 0}, is_clockwise);
    const auto mesh = lay_fill(region);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->elements.size(), 12u);
    EXPECT_EQ(mesh->node_count(), 20);
    double area = 0;
    for (const Element& e : mesh->elements) {
      EXPECT_TRUE(is_positive(*mesh, e));
      area += 0.5 * cross(mesh->p[e.v[2]] - mesh->p[e.v[0]], mesh->p[e.v[3]] - mesh->p[e.v[1]]);
    }
    EXPECT_NEAR(area, 12, 1e-12);
    std::map<int, int> of_global;
    for (int v = 0; v < mesh->node_count(); ++v)
      if (mesh->global[v] >= 0) of_global[mesh->global[v]] = v;
    for (const LoopNode& node : region.loops[0]) {
      ASSERT_TRUE(of_global.contains(node.global));
      const int v = of_global[node.global];
      EXPECT_EQ(mesh->x[v], node.x);
      EXPECT_EQ(mesh->h[v], 0.5);
      EXPECT_TRUE(mesh->is_fixed[v]);
    }
  }
}

TEST(LayFill, IsNothingWhereACellFolds) { EXPECT_FALSE(lay_fill(half({-7, -3}, false))); }

TEST(LayFill, IsNothingForOtherRegions) { EXPECT_FALSE(lay_fill(Region{})); }

}  // namespace
}  // namespace paver
