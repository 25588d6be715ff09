// Domes of few nodes: rows and a fan about the middle; everything else is left to paving.
#include "paving/dome_grid.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <cmath>
#include <set>

#include "support/dome.h"
#include "support/planar_region.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::circle;
using test::dome;
using test::region_on;

long triangles(const RegionMesh& mesh) {
  return std::count_if(mesh.elements.begin(), mesh.elements.end(), [](const Element& e) { return e.corners() == 3; });
}

double chart_area(const RegionMesh& mesh) {
  double twice = 0;
  for (const Element& e : mesh.elements)
    for (int k = 0, n = e.corners(); k < n; ++k) twice += cross(mesh.p[e.v[k]], mesh.p[e.v[(k + 1) % n]]);
  return 0.5 * twice;
}

TEST(DomeGrid, HasARowOfQuadsAndHalfAsManyAboutTheMiddle) {
  const auto mesh = lay_dome(dome(0, 12, 10), Elements::quad_dominant);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->elements.size(), 12U + 6U);
  EXPECT_EQ(triangles(*mesh), 0);
  EXPECT_EQ(mesh->node_count(), 12 + 12 + 1);
  EXPECT_NEAR(chart_area(*mesh), 0.75, 1e-12) << "of a regular twelve-gon";
}

TEST(DomeGrid, HasMoreRowsTheHigherItIs) {
  const auto flat = lay_dome(dome(0, 12, 0.2), Elements::quad_dominant);
  const auto high = lay_dome(dome(2, 12, 0.2), Elements::quad_dominant);
  ASSERT_TRUE(flat && high);
  EXPECT_EQ(flat->elements.size(), 6U + 12 * 2);
  EXPECT_EQ(high->elements.size(), 6U + 12 * 4);
}

TEST(DomeGrid, KeepsTheNodesOfTheLoop) {
  const Region region = dome(0.3, 9, 0.3);
  const auto mesh = lay_dome(region, Elements::quad_dominant);
  ASSERT_TRUE(mesh);
  std::set<int> known;
  for (std::size_t v = 0; v < mesh->x.size(); ++v) {
    if (mesh->global[v] < 0) continue;
    known.insert(mesh->global[v]);
    EXPECT_EQ(mesh->x[v], region.loops[0][static_cast<std::size_t>(mesh->global[v] - 100)].x);
    EXPECT_TRUE(mesh->is_fixed[v]);
  }
  EXPECT_EQ(known.size(), 9U);
}

TEST(DomeGrid, AnOddLoopHasOneTriangleWhereTheseMayBe) {
  const auto mesh = lay_dome(dome(0.3, 9, 1), Elements::quad_dominant);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(triangles(*mesh), 1);
  EXPECT_FALSE(lay_dome(dome(0.3, 9, 1), Elements::all_quad));
}

TEST(DomeGrid, HasAQuadInTheMiddleOfFourNodes) {
  const auto mesh = lay_dome(dome(0, 4, 1), Elements::all_quad);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->elements.size(), 4U + 1U);
  EXPECT_EQ(triangles(*mesh), 0);
  EXPECT_EQ(mesh->node_count(), 4 + 4);
  EXPECT_NEAR(chart_area(*mesh), 0.5, 1e-12);
}

TEST(DomeGrid, LeavesToPavingWhatHasManyNodesOrLoopsOrIsNoStar) {
  EXPECT_FALSE(lay_dome(dome(0.3, 3, 1), Elements::quad_dominant));
  EXPECT_FALSE(lay_dome(dome(0.3, 40, 0.1), Elements::quad_dominant));
  Region ring = dome(0.3, 12, 1);
  ring.loops.push_back(ring.loops[0]);
  EXPECT_FALSE(lay_dome(ring, Elements::quad_dominant));
  const auto plane = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  const Region ell = region_on(plane, {{0, 0}, {0.5, 0}, {1, 0}, {1, 0.1}, {0.1, 0.1}, {0.1, 1}, {0, 1}, {0, 0.5}}, 1);
  EXPECT_FALSE(lay_dome(ell, Elements::quad_dominant));
}

/// Two circles of n nodes, the inner one from another node on.
Region ring(int n, int inner_n) {
  std::vector<Vec2> outer, inner;
  for (int i = 0; i < n; ++i) outer.push_back({3 * std::cos(2 * M_PI * i / n), 3 * std::sin(2 * M_PI * i / n)});
  for (int i = 0; i < inner_n; ++i) {
    const double angle = -2 * M_PI * (i + 4) / inner_n;
    inner.push_back({std::cos(angle), std::sin(angle)});
  }
  return test::planar_region({outer, inner}, 1);
}

TEST(TubeGrid, HasRowsFromLoopToLoopWhereNodesFaceEachOther) {
  const auto mesh = lay_tube(ring(12, 12));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->elements.size(), 24U);
  EXPECT_EQ(triangles(*mesh), 0);
  EXPECT_NEAR(chart_area(*mesh), 3 * (9 - 1), 1e-12) << "between regular twelve-gons";
  for (const Element& e : mesh->elements) EXPECT_GT(scaled_jacobian(*mesh, e), 0.9);
}

TEST(TubeGrid, IsSlimWhereBothEndsAreNarrowerThanTheTargetLength) {
  Region region = ring(12, 12);
  EXPECT_FALSE(is_slim_tube(region));
  region.h = 9;
  EXPECT_TRUE(is_slim_tube(region));
  region.loops.pop_back();
  EXPECT_FALSE(is_slim_tube(region));
}

TEST(TubeGrid, IsNoneWhereTheLoopsDifferOrAreMany) {
  EXPECT_FALSE(lay_tube(ring(12, 11)));
  EXPECT_FALSE(lay_tube(ring(60, 60)));
  EXPECT_FALSE(lay_tube(dome(0, 12, 1)));
}

TEST(TubeGrid, AGrooveOfHalfACircleHasRowsAtTheLowestFrequency) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -6), 40, 40, 6).Shape();
  for (const double radius : {1.0, 2.0}) {
    const TopoDS_Shape groove = BRepPrimAPI_MakeTorus(10, radius).Shape();
    for (const TopoDS_Shape& shape :
         {BRepAlgoAPI_Cut(plate, groove).Shape(), BRepAlgoAPI_Fuse(plate, groove).Shape()}) {
      const RunReport report = test::report_of(shape, 1e6);
      EXPECT_STREQ(verdict(report), "sound") << radius;
      EXPECT_EQ(report.quality.triangles, 0) << radius;
    }
  }
}

}  // namespace
}  // namespace paver
