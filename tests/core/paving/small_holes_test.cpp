#include "paving/small_holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "paving/cleanup/clean_up.h"
#include "paving/fill_void.h"
#include "paving/pave_region.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
using test::planar_region;
using test::reversed;

std::vector<Vec2> square(double side, double h) { return divided({{0, 0}, {side, 0}, {side, side}, {0, side}}, h); }

std::vector<Vec2> hole(Vec2 at, double radius, int n) { return reversed(circle(at, radius, n)); }

struct Figures {
  long elements = 0, triangles = 0, irregular = 0;
  double worst = 1;
};

Figures pave(const Region& region) {
  PavedRegion paved = pave_region(region, Progress());
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  Figures figures;
  const RegionMesh& mesh = paved.mesh;
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    ++figures.elements;
    figures.triangles += e.corners() == 3;
    figures.worst = std::min(figures.worst, scaled_jacobian(mesh, e));
  }
  for (int v = 0; v < mesh.node_count(); ++v)
    figures.irregular += mesh.star[v].size() > 0 && !mesh.is_fixed[v] && mesh.star[v].size() != 4;
  return figures;
}

TEST(SmallHoles, AreThoseOfFewFacetsFarFromOthers) {
  std::vector<Vec2> outer = square(20, 1);
  Region region = planar_region({outer, hole({5, 5}, 0.4, 6), hole({10, 14}, 2.5, 50), hole({2, 16}, 0.4, 6),
                                 hole({15, 5}, 0.5, 7), hole({14.8, 9.7}, 0.2, 6), hole({15.3, 9.7}, 0.2, 6)},
                                1);
  EXPECT_EQ(small_holes(region), (std::vector<std::size_t>{1})) << "many facets, at the border, odd, two side by side";
  EXPECT_EQ(without_holes(region, {1}).loops.size(), region.loops.size() - 1);
}

TEST(SmallHoles, TheAxisOfATubeIsNone) {
  Region region = planar_region({circle({0, 0}, 10, 62), hole({0, 0}, 1, 8)}, 1);
  EXPECT_EQ(small_holes(region).size(), 1u);
  region.goes_round = true;
  EXPECT_TRUE(small_holes(region).empty());
}

// A board with rows of pins and one hole apart: that many elements are there before it is cut.
TEST(SmallHoles, AreCutIntoMeshesFarFinerThanTheTargetLength) {
  std::vector<std::vector<Vec2>> loops{square(120, 8)};
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) loops.push_back(hole({5 + 3.0 * i, 5 + 3.0 * k}, 0.6, 12));
  loops.push_back(hole({95, 95}, 0.5, 6));
  const Figures figures = pave(planar_region(loops, 8));
  EXPECT_GT(figures.elements, 10000);
}

TEST(SmallHoles, LeaveTheGridOfAPlateAsItIs) {
  const int n = 30;
  std::vector<std::vector<Vec2>> loops{square(n, 1)};
  for (double y : {8.2, 22.6})
    for (double x : {7.5, 21.0}) loops.push_back(hole({x, y}, 0.8, 6));
  Figures figures = pave(planar_region(loops, 1));
  EXPECT_EQ(figures.triangles, 0);
  EXPECT_LE(figures.irregular, 4 * 8);
  EXPECT_NEAR(static_cast<double>(figures.elements), n * n, 0.04 * n * n);
  EXPECT_GT(figures.worst, 0.6);
}

// Where the ring about a hole leaves triangles all is paved, with some 60 irregular nodes: one place in twenty.
TEST(SmallHoles, LeaveTheCoreOfADiscAsItIs) {
  int paved = 0;
  for (Vec2 at : {Vec2{-5, 3}, Vec2{5, 3}, Vec2{0, 0}, Vec2{1.3, -8}, Vec2{7.7, 4.4}, Vec2{10, -3}}) {
    Region region = planar_region({circle({0, 0}, 20, 126), hole(at, 0.3, 6)}, 1);
    region.gradation = 0.6;
    for (LoopNode& node : region.loops[0]) node.angle = std::numbers::pi;
    Figures figures = pave(region);
    EXPECT_EQ(figures.triangles, 0);
    EXPECT_GT(figures.worst, 0.6);
    paved += figures.irregular > 4 + 16;
  }
  EXPECT_LE(paved, 1);
}

TEST(SmallHoles, MayBeOfAnyWidthUpToTheirLimit) {
  for (int n : {4, 6, 8, 10, 12, 18, 24})
    for (double radius : {0.02, 0.2, 0.16 * n}) {
      if (n > 12 && radius < 1) continue;  // facets far shorter than elements
      SCOPED_TRACE(testing::Message() << n << " facets, radius " << radius);
      Figures figures = pave(planar_region({square(16, 1), hole({7.6, 8.3}, radius, n)}, 1));
      EXPECT_EQ(figures.triangles, 0);
      EXPECT_GT(figures.worst, 0.3);
    }
}

/// Holes of 10 to 24 facets in rows, 12 apart, on a plate with a target length of 1.
Region perforated_plate(int holes) {
  std::vector<std::vector<Vec2>> loops{square(12 * holes, 1)};
  for (int i = 0; i < holes * holes; ++i) {
    const int n = 10 + 2 * (i % 8);
    const Vec2 at{12 * (i % holes) + 5.7 + 0.1 * (i % 5), 12 * (i / holes) + 6.2 - 0.1 * (i % 7)};
    loops.push_back(hole(at, 0.16 * n, n));
  }
  return planar_region(loops, 1);
}

TEST(SmallHoles, LeaveNoTrianglesInAPlateOfMany) {
  const Figures figures = pave(perforated_plate(6));
  EXPECT_GT(figures.elements, 4000);
  EXPECT_EQ(figures.triangles, 0);
  EXPECT_LT(figures.irregular, 6 * 6 * 8);
  EXPECT_GT(figures.worst, 0.4);
}

TEST(SmallHoles, AreCutAnewWithoutTouchingTheRest) {
  const Region region = perforated_plate(2);
  const std::vector<std::size_t> holes = small_holes(region);
  ASSERT_EQ(holes.size(), 4u);
  RegionMesh mesh = pave_region(without_holes(region, holes), Progress()).mesh;
  const HoleLoops loops = add_holes(region, mesh, holes);
  for (const std::vector<char>& is_wanted : {std::vector<char>{1, 1, 1, 1}, std::vector<char>{0, 0, 1, 0}}) {
    const RegionMesh before = mesh;
    Front front(region, mesh);
    ASSERT_TRUE(cut_about(front, loops, is_wanted, is_wanted[0] ? 0.8 : 1.2));
    for (std::size_t e = 0; e < before.elements.size(); ++e) {
      if (!before.elements[e].is_alive() || mesh.elements[e].is_alive()) continue;
      double nearest = 1e300;
      for (std::size_t i = 0; i < holes.size(); ++i)
        for (int v : loops.nodes[i])
          if (is_wanted[i]) nearest = std::min(nearest, norm(mesh.x[v] - mesh.x[before.elements[e].v[0]]));
      EXPECT_LT(nearest, 4) << "element " << e;
    }
    fill_void(front, Progress());
    clean_up(front, Progress(), false, before.node_count());
    EXPECT_EQ(test::paved_faults(region, mesh), "");
  }
}

TEST(SmallHoles, KnowTheTrianglesBesideThem) {
  const Region region = perforated_plate(2);
  const std::vector<std::size_t> holes = small_holes(region);
  RegionMesh mesh = pave_region(without_holes(region, holes), Progress()).mesh;
  const HoleLoops loops = add_holes(region, mesh, holes);
  EXPECT_EQ(are_at_triangles(region, mesh, loops), std::vector<char>(4, false));
  const Vec3 at = mesh.x[loops.nodes[2][0]];
  int nearest = 0;
  for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
    if (norm(mesh.x[mesh.elements[e].v[0]] - at) < norm(mesh.x[mesh.elements[nearest].v[0]] - at)) nearest = e;
  const Corners quad = mesh.elements[nearest].v;
  mesh.remove_element(nearest);
  mesh.add_element({quad[0], quad[1], quad[2], -1});
  mesh.add_element({quad[0], quad[2], quad[3], -1});
  EXPECT_EQ(are_at_triangles(region, mesh, loops), (std::vector<char>{0, 0, 1, 0}));
}

}  // namespace
}  // namespace paver
