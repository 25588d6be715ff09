// Meshes of valid elements that are not what the face is, or less than a grid would be.
#include "repair/other_ways.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>

#include "support/dome.h"
#include "support/planar_region.h"
#include "support/report_of.h"

namespace paver {
namespace {

Region without_edges(Region region) {
  for (auto& loop : region.loops)
    for (LoopNode& node : loop) node.edge = -1;
  return region;
}

/// What a region is meshed with, and what comes of it.
struct Trial {
  explicit Trial(Region r) : region(without_edges(std::move(r))) {
    face.surface = region.surface;
    for (const LoopNode& node : region.loops[0]) add_node(region, node, paved.mesh);
  }
  bool can_help() const { return ways().can_help(paved.mesh); }
  Mended improve() {
    Mended mended;
    ways().improve(mended, paved);
    return mended;
  }
  OtherWays ways() const { return {region, face, sides, options, progress}; }
  long count(int corners) const {
    return std::count_if(paved.mesh.elements.begin(), paved.mesh.elements.end(),
                         [&](const Element& e) { return e.is_alive() && e.corners() == corners; });
  }

  Region region;
  Face face;
  EdgeNodes edges;
  BoundarySides sides{region, edges};
  Options options;
  Progress progress;
  PavedRegion paved;
};

/// Inside the circle of the unit square, mm^2.
double area_of(const Surface& surface) {
  constexpr int n = 400;
  double area = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const Vec2 uv{(i + 0.5) / n, (j + 0.5) / n};
      if (norm(uv - Vec2{0.5, 0.5}) > 0.5) continue;
      const auto [x, xu, xv] = surface.slope(uv);
      area += norm(cross(xu, xv)) / (n * n);
    }
  return area;
}

TEST(OtherWays, AFaceThatItsElementsDoNotCoverBecomesADome) {
  Trial trial(test::dome(2.8, 12, 1));
  trial.options.elements = Elements::all_quad;
  trial.region.own_area = area_of(*trial.region.surface);
  for (int i = 0; i < 5; ++i) trial.paved.mesh.add_element({i, i + 1, 10 - i, 11 - i});  // straight across
  EXPECT_TRUE(trial.can_help());
  const Mended mended = trial.improve();
  ASSERT_FALSE(mended.places.empty());
  EXPECT_EQ(mended.places.back().kind, ElementRepairKind::paved_again);
  EXPECT_GT(trial.count(4), 12);
  EXPECT_FALSE(trial.can_help());
}

// Valid, and lacking a part of the area that the check still lets pass.
TEST(OtherWays, TrianglesTooCoarseForTheirFaceBecomeADome) {
  Trial trial(test::dome(1.6, 16, 1));
  trial.region.own_area = area_of(*trial.region.surface);
  for (int i = 0; i < 7; ++i) {
    trial.paved.mesh.add_element({i, i + 1, 14 - i, -1});
    trial.paved.mesh.add_element({i, 14 - i, 15 - i, -1});
  }
  EXPECT_TRUE(trial.ways().is_sound(trial.paved.mesh));
  EXPECT_TRUE(trial.can_help());
  const double lacks = trial.ways().lacking(trial.paved.mesh);
  EXPECT_FALSE(trial.improve().places.empty());
  EXPECT_LT(trial.ways().lacking(trial.paved.mesh), 0.5 * lacks);
  EXPECT_EQ(trial.count(3), 0);
}

TEST(OtherWays, WhatCoversAFaceTooCoarselyMakesWayForMore) {
  Trial trial(test::dome(2.4, 10, 4));
  trial.region.own_area = area_of(*trial.region.surface);
  for (int i = 0; i < 4; ++i) trial.paved.mesh.add_element({i, i + 1, 8 - i, 9 - i});
  EXPECT_FALSE(trial.ways().is_sound(trial.paved.mesh));
  EXPECT_FALSE(trial.improve().places.empty());
  EXPECT_FALSE(trial.can_help()) << "a dome of one row lacks 4.5 %";
}

TEST(OtherWays, AFaceThatItsElementsCoverStays) {
  Trial trial(test::dome(0, 12, 1));
  trial.region.own_area = 0.75;
  for (int i = 0; i < 5; ++i) trial.paved.mesh.add_element({i, i + 1, 10 - i, 11 - i});
  EXPECT_FALSE(trial.can_help());
  EXPECT_TRUE(trial.improve().places.empty());
  EXPECT_EQ(trial.count(4), 5);
}

/// A square of two intervals a side, as four triangles and a quad.
struct MixedSquare : Trial {
  MixedSquare() : Trial(test::planar_region({test::divided({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 1)}, 1)) {
    region.own_area = 4;
    for (std::size_t i = 0; i < 8; ++i) region.loops[0][i].angle = i % 2 == 0 ? fake::pi / 2 : fake::pi;
    for (int k = 0; k < 4; ++k) paved.mesh.add_element({2 * k, 2 * k + 1, (2 * k + 7) % 8, -1});
    paved.mesh.add_element({1, 3, 5, 7});
  }
};

void expect_to_lose_its_triangles(Trial& trial) {
  EXPECT_TRUE(trial.can_help());
  EXPECT_EQ(trial.improve().places.size(), 1U);
  EXPECT_EQ(trial.count(3), 0);
}

TEST(OtherWays, AFewElementsWithTrianglesBecomeAGridWhereThatIsBetter) {
  MixedSquare square;
  expect_to_lose_its_triangles(square);
  EXPECT_EQ(square.count(4), 4);
}

/// A square with a square hole, three intervals and one a side: a target length far above these left two triangles at
/// every corner.
struct MixedFrame : Trial {
  MixedFrame()
      : Trial(test::planar_region({test::divided({{0, 0}, {6, 0}, {6, 6}, {0, 6}}, 2),
                                   test::reversed(test::divided({{2, 2}, {4, 2}, {4, 4}, {2, 4}}, 2))},
                                  20)) {
    for (const LoopNode& node : region.loops[1]) add_node(region, node, paved.mesh);
    const auto inner = [](int i) { return 15 - i % 4; };
    for (int k = 0; k < 4; ++k) {
      const int a = 3 * k, end = (a + 3) % 12;
      paved.mesh.add_element({a, a + 1, inner(k), -1});
      paved.mesh.add_element({a + 1, a + 2, inner(k + 1), inner(k)});
      paved.mesh.add_element({a + 2, end, inner(k + 1), -1});
    }
  }
};

TEST(OtherWays, TrianglesAboutAHoleMakeWayForQuadsAsLongAsItsSides) {
  MixedFrame frame;
  expect_to_lose_its_triangles(frame);
  EXPECT_LE(frame.count(4), 12);
}

// As where the front of a thin rod closes along it.
TEST(OtherWays, ElementsFarTooLongBecomeRows) {
  constexpr int n = 24;
  Trial trial(test::planar_region({test::circle({0, 0}, 2.5, n), test::reversed(test::circle({0, 0}, 1, n))}, 0.35));
  for (const LoopNode& node : trial.region.loops[1]) add_node(trial.region, node, trial.paved.mesh);
  const auto inner = [&](int i) { return n + (2 * n - 1 - i) % n; };
  for (int i = 0; i < n; ++i) trial.paved.mesh.add_element({i, (i + 1) % n, inner(i + 1), inner(i)});
  EXPECT_TRUE(trial.can_help());
  EXPECT_EQ(trial.improve().places.size(), 1U);
  EXPECT_EQ(trial.count(4), 4 * n);
  EXPECT_FALSE(trial.can_help());
}

// Elements as long as the facets about it reach round the tube: they held nodes of the periodic edge twice.
TEST(OtherWays, ATorusWithANotchAtItsPeriodicEdgeGetsSmallerElements) {
  const TopoDS_Shape ring = BRepPrimAPI_MakeTorus(25, 5).Shape(),
                     notch = BRepPrimAPI_MakeBox(gp_Pnt(-40, -10, -10), gp_Pnt(0, 10, 0)).Shape();
  EXPECT_STREQ(verdict(test::report_of(BRepAlgoAPI_Cut(ring, notch).Shape(), 1e6)), "sound");
}

TEST(OtherWays, NoGridWhereTrianglesAreAskedFor) {
  MixedSquare square;
  square.options.elements = Elements::all_triangle;
  EXPECT_FALSE(square.can_help());
  EXPECT_TRUE(square.improve().places.empty());
  EXPECT_EQ(square.count(3), 4);
}

}  // namespace
}  // namespace paver
