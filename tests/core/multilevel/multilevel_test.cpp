// Whole regions on several levels: what comes out is as sound as any paved mesh, and more regular.
#include "multilevel/multilevel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "multilevel/pieces.h"
#include "support/levels.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
using test::pave_on_levels;
using test::planar_region;
using test::reversed;

using Loops = std::vector<std::vector<Vec2>>;

Region with_area(const Loops& loops, double h) {
  Region region = planar_region(loops, h);
  region.area = test::chart_area(region);
  return region;
}

struct Figures {
  long quads = 0, triangles = 0, irregular = 0;
};

Figures figures_of(const RegionMesh& mesh) {
  Figures figures;
  for (const Element& e : mesh.elements)
    if (e.is_alive()) ++(e.corners() == 4 ? figures.quads : figures.triangles);
  for (int v = 0; v < mesh.node_count(); ++v)
    figures.irregular += mesh.global[v] < 0 && mesh.star[v].size() > 0 && mesh.star[v].size() != 4;
  return figures;
}

/// Plate with a round hole: 33,500 elements.
Loops plate(int hole) {
  return {divided({{0, 0}, {200, 0}, {200, 200}, {0, 200}}, 1), reversed(circle({90, 110}, 45, hole))};
}

TEST(PlanLevels, IsSoundAndRegular) {
  Region region = with_area(plate(282), 1);
  Figures direct = figures_of(pave_on_levels(region, 0, Progress()));
  RegionMesh paved = pave_on_levels(region, 6, Progress());
  EXPECT_EQ(test::paved_faults(region, paved), "");
  Figures figures = figures_of(paved);
  EXPECT_EQ(figures.triangles, 0);
  EXPECT_NEAR(static_cast<double>(figures.quads), region.area, 0.03 * region.area);
  EXPECT_LT(2.5 * static_cast<double>(figures.irregular), static_cast<double>(direct.irregular));
}

TEST(PlanLevels, SmallRegionsAreNotDividedUnasked) {
  Region region = with_area({divided({{0, 0}, {50, 0}, {50, 60}, {0, 60}}, 1)}, 1);
  RegionMesh direct = pave_on_levels(region, 0, Progress());
  RegionMesh unasked = pave_on_levels(region, automatic_levels, Progress());
  EXPECT_TRUE(direct.p == unasked.p);
}

// Also where no ratio divides the sides.
TEST(PlanLevels, ARectangleBecomesAGrid) {
  for (auto [a, b] : {std::pair{241.0, 120.0}, {201.0, 80.0}, {173.0, 211.0}, {330.0, 59.0}}) {
    Region region = with_area({divided({{0, 0}, {a, 0}, {a, b}, {0, b}}, 1)}, 1);
    for (int ratio : {automatic_levels, 4, 6}) {
      RegionMesh paved = pave_on_levels(region, ratio, Progress());
      EXPECT_EQ(test::paved_faults(region, paved), "");
      Figures figures = figures_of(paved);
      EXPECT_EQ(figures.irregular, 0) << a << " by " << b;
      EXPECT_EQ(figures.quads, std::lround(a * b));
    }
  }
}

// Along its long sides edges are shorter than asked for, as where a neighbour has more of them.
TEST(PlanLevels, SidesMayBeDividedMoreFinelyThanAskedFor) {
  std::vector<Vec2> loop;
  auto add_side = [&](Vec2 from, Vec2 to, int count) {
    for (int i = 0; i < count; ++i) loop.push_back(from + (static_cast<double>(i) / count) * (to - from));
  };
  add_side({0, 0}, {300, 0}, 360), add_side({300, 0}, {300, 60}, 60);
  add_side({300, 60}, {0, 60}, 360), add_side({0, 60}, {0, 0}, 60);
  Region region = with_area({loop}, 1);
  for (LoopNode& node : region.loops[0]) node.h = 1;
  ASSERT_TRUE(
      plan_levels(region, automatic_levels, test::boundary_nodes_of(region), Progress(), Elements::quad_dominant));
  EXPECT_EQ(test::paved_faults(region, pave_on_levels(region, automatic_levels, Progress())), "");
}

TEST(PlanLevels, TheSameEveryTime) {
  Region region = with_area(plate(280), 1);
  RegionMesh a = pave_on_levels(region, 4, Progress());
  RegionMesh b = pave_on_levels(region, 4, Progress());
  EXPECT_TRUE(a.p == b.p);
  EXPECT_TRUE(a.x == b.x);
}

TEST(PlanLevels, AnOddRegionHasOneTriangle) {
  Region region = with_area(plate(281), 1);
  RegionMesh paved = pave_on_levels(region, 4, Progress());
  EXPECT_EQ(test::paved_faults(region, paved), "");
  EXPECT_EQ(figures_of(paved).triangles, 1);
}

TEST(PlanLevels, KindsOfElements) {
  Region region = with_area(plate(282), 1);
  RegionMesh triangles = pave_on_levels(region, 4, Progress(), Elements::all_triangle);
  EXPECT_EQ(test::paved_faults(region, triangles), "");
  EXPECT_EQ(figures_of(triangles).quads, 0);
  RegionMesh quads = pave_on_levels(region, 4, Progress(), Elements::all_quad);
  EXPECT_EQ(test::paved_faults(region, quads), "");
  EXPECT_EQ(figures_of(quads).triangles, 0);
}

/// Holes of few nodes, narrow arms and acute corners all have to come out as they went in.
TEST(PlanLevels, TakesWhateverTheBoundaryIs) {
  const std::vector<Loops> shapes = {
      {divided({{0, 0}, {300, 0}, {300, 8}, {120, 8}, {120, 270}, {0, 270}}, 1)},
      {divided({{0, 0}, {330, 0}, {20, 260}}, 1)},
      {divided({{0, 0}, {200, 0}, {200, 200}, {0, 200}}, 1), reversed(circle({50, 50}, 2, 12)),
       reversed(circle({140, 120}, 1, 6)), reversed(divided({{90, 20}, {110, 20}, {110, 60}, {90, 60}}, 1))},
  };
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (int ratio : {4, 7}) {
      Region region = with_area(shapes[i], 1);
      RegionMesh paved = pave_on_levels(region, ratio, Progress());
      EXPECT_EQ(test::paved_faults(region, paved), "") << i << ", " << ratio;
    }
}

TEST(PlanLevels, EndsWhenCancelled) {
  Progress progress;
  progress.cancel();
  try {
    pave_on_levels(with_area(plate(282), 1), 4, progress);
    FAIL() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
  }
}

TEST(LevelPlan, PiecesAreOfAboutOneSizeAndMeetInTheSameNodes) {
  Region region = with_area(plate(282), 1);
  const int boundary = test::boundary_nodes_of(region);
  auto plan = plan_levels(region, 4, boundary, Progress(), Elements::quad_dominant);
  ASSERT_TRUE(plan);
  EXPECT_GE(plan->pieces.size(), 6u);
  std::map<int, std::vector<Vec3>> places;
  for (std::size_t i = 0; i < plan->pieces.size(); ++i) {
    RegionMesh mesh = lay_piece(region, without_loops(region), *plan, i, Progress(), Elements::quad_dominant).mesh;
    if (!plan->is_paved[static_cast<std::size_t>(plan->pieces[i][0])]) {
      EXPECT_NEAR(static_cast<double>(mesh.elements.size()), 4096, 2048) << i;
    }
    for (int v = 0; v < mesh.node_count(); ++v)
      if (mesh.global[v] >= boundary) places[mesh.global[v] - boundary].push_back(mesh.x[v]);
  }
  EXPECT_EQ(static_cast<int>(places.size()), plan->outline_nodes);
  for (const auto& [node, at] : places) {
    EXPECT_GE(at.size(), 2u) << node;
    for (Vec3 x : at) EXPECT_TRUE(x == at.front()) << node;
  }
}

TEST(LevelPlan, IsTheSameAfterPackingAndUnpacking) {
  Region region = with_area(plate(280), 1);
  auto plan = plan_levels(region, 4, test::boundary_nodes_of(region), Progress(), Elements::quad_dominant);
  ASSERT_TRUE(plan);
  const std::string bytes = pack(*plan);
  LevelPlan unpacked = unpack_plan(bytes);
  EXPECT_EQ(pack(unpacked), bytes);
  EXPECT_EQ(unpacked.outline_sides, plan->outline_sides);
  for (std::size_t i = 0; i < plan->pieces.size(); ++i) {
    RegionMesh a = lay_piece(region, without_loops(region), *plan, i, Progress(), Elements::quad_dominant).mesh;
    RegionMesh b = lay_piece(region, without_loops(region), unpacked, i, Progress(), Elements::quad_dominant).mesh;
    EXPECT_TRUE(a.p == b.p && a.x == b.x && a.global == b.global) << i;
  }
}

// A band across the plate, as a blade's leading edge: neither half of it may ask for a triangle.
TEST(CutInPieces, WhatIsPavedTogetherFallsIntoAFewPieces) {
  const Region region = with_area(plate(282), 1);
  const int boundary = test::boundary_nodes_of(region);
  for (double half : {12.0, 15.0, 18.0}) {
    auto plan = plan_levels(region, 6, boundary, Progress(), Elements::quad_dominant);
    ASSERT_TRUE(plan);
    for (std::size_t e = 0; e < plan->is_paved.size(); ++e) {
      const Element& element = plan->mesh.elements[e];
      if (element.is_alive() && std::fabs(plan->mesh.p[element.v[0]].x - 165) < half) plan->is_paved[e] = true;
    }
    cut_in_pieces(region, *plan, 4096);
    number_outlines(*plan);
    int paved = 0;
    std::vector<RegionMesh> pieces;
    for (std::size_t i = 0; i < plan->pieces.size(); ++i) {
      paved += plan->is_paved[plan->pieces[i].front()] != 0;
      pieces.push_back(lay_piece(region, without_loops(region), *plan, i, Progress(), Elements::quad_dominant).mesh);
      EXPECT_EQ(figures_of(pieces.back()).triangles, 0) << half;
    }
    EXPECT_GT(paved, 1) << half;
    EXPECT_EQ(test::paved_faults(region, test::put_together(pieces, boundary)), "") << half;
  }
}

}  // namespace
}  // namespace paver
