// Whole regions on several levels: what comes out is as sound as any paved mesh, and more regular.
#include "multilevel/multilevel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
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

TEST(PaveByLevels, IsSoundAndRegular) {
  Region region = with_area(plate(282), 1);
  Figures direct = figures_of(pave_by_levels(region, 0, Progress(), Elements::quad_dominant).mesh);
  PavedRegion paved = pave_by_levels(region, 6, Progress(), Elements::quad_dominant);
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  Figures figures = figures_of(paved.mesh);
  EXPECT_EQ(figures.triangles, 0);
  EXPECT_NEAR(static_cast<double>(figures.quads), region.area, 0.03 * region.area);
  EXPECT_LT(4 * figures.irregular, direct.irregular);
}

TEST(PaveByLevels, SmallRegionsAreNotDividedUnasked) {
  Region region = with_area(plate(200), 1);
  RegionMesh direct = pave_by_levels(region, 0, Progress(), Elements::quad_dominant).mesh;
  RegionMesh unasked = pave_by_levels(region, automatic_levels, Progress(), Elements::quad_dominant).mesh;
  EXPECT_TRUE(direct.p == unasked.p);
}

TEST(PaveByLevels, TheSameEveryTime) {
  Region region = with_area(plate(280), 1);
  RegionMesh a = pave_by_levels(region, 4, Progress(), Elements::quad_dominant).mesh;
  RegionMesh b = pave_by_levels(region, 4, Progress(), Elements::quad_dominant).mesh;
  EXPECT_TRUE(a.p == b.p);
  EXPECT_TRUE(a.x == b.x);
}

TEST(PaveByLevels, AnOddRegionHasOneTriangle) {
  Region region = with_area(plate(281), 1);
  PavedRegion paved = pave_by_levels(region, 4, Progress(), Elements::quad_dominant);
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  EXPECT_EQ(figures_of(paved.mesh).triangles, 1);
}

TEST(PaveByLevels, KindsOfElements) {
  Region region = with_area(plate(282), 1);
  RegionMesh triangles = pave_by_levels(region, 4, Progress(), Elements::all_triangle).mesh;
  EXPECT_EQ(test::paved_faults(region, triangles), "");
  EXPECT_EQ(figures_of(triangles).quads, 0);
  RegionMesh quads = pave_by_levels(region, 4, Progress(), Elements::all_quad).mesh;
  EXPECT_EQ(test::paved_faults(region, quads), "");
  EXPECT_EQ(figures_of(quads).triangles, 0);
}

/// Holes of few nodes, narrow arms and acute corners all have to come out as they went in.
TEST(PaveByLevels, TakesWhateverTheBoundaryIs) {
  const std::vector<Loops> shapes = {
      {divided({{0, 0}, {300, 0}, {300, 8}, {120, 8}, {120, 270}, {0, 270}}, 1)},
      {divided({{0, 0}, {330, 0}, {20, 260}}, 1)},
      {divided({{0, 0}, {200, 0}, {200, 200}, {0, 200}}, 1), reversed(circle({50, 50}, 2, 12)),
       reversed(circle({140, 120}, 1, 6)), reversed(divided({{90, 20}, {110, 20}, {110, 60}, {90, 60}}, 1))},
  };
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (int ratio : {4, 7}) {
      Region region = with_area(shapes[i], 1);
      PavedRegion paved = pave_by_levels(region, ratio, Progress(), Elements::quad_dominant);
      EXPECT_EQ(test::paved_faults(region, paved.mesh), "") << i << ", " << ratio;
    }
}

TEST(PaveByLevels, EndsWhenCancelled) {
  Progress progress;
  progress.cancel();
  try {
    pave_by_levels(with_area(plate(282), 1), 4, progress, Elements::quad_dominant);
    FAIL() << "it went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
  }
}

}  // namespace
}  // namespace paver
