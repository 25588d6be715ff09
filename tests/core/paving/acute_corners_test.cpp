#include "paving/closing/acute_corners.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/brep/shape_files.h"
#include "paving/pave_region.h"
#include "support/paved_model.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::planar_region;

/// Slice of a round cake: its corner at the origin, `rows` nodes of distance 1 along either side.
Region slice(double angle, int rows, bool is_even = true) {
  std::vector<Vec2> loop;
  for (int i = 0; i < rows; ++i) loop.push_back({static_cast<double>(i), 0});
  int across = std::max(1, static_cast<int>(std::lround(rows * angle)));
  if ((across % 2 == 0) != is_even) ++across;
  for (int i = 0; i < across; ++i)
    loop.push_back({rows * std::cos(angle * i / across), rows * std::sin(angle * i / across)});
  for (int i = rows; i > 0; --i) loop.push_back({i * std::cos(angle), i * std::sin(angle)});
  return planar_region({loop}, 1);
}

struct Figures {
  int triangles = 0;
  double worst = 1, longest = 0;
};

Figures pave(const Region& region, Elements elements = Elements::quad_dominant) {
  PavedRegion paved = pave_region(region, Progress(), elements);
  EXPECT_EQ(test::paved_faults(region, paved.mesh), "");
  Figures figures;
  const RegionMesh& mesh = paved.mesh;
  for (const Element& e : mesh.elements) {
    if (!e.is_alive()) continue;
    figures.triangles += e.corners() == 3;
    figures.worst = std::min(figures.worst, scaled_jacobian(mesh, e));
    for (int k = 0; k < e.corners(); ++k)
      figures.longest = std::max(figures.longest, norm(mesh.x[e.v[k]] - mesh.x[e.v[(k + 1) % e.corners()]]));
  }
  return figures;
}

class Slices : public testing::TestWithParam<int> {};

TEST_P(Slices, HaveNoTriangleAndNoElementWorseThanTheirCorner) {
  double angle = GetParam() * std::numbers::pi / 180;
  for (int rows : {8, 20, 41}) {
    SCOPED_TRACE(rows);
    Figures figures = pave(slice(angle, rows));
    EXPECT_EQ(figures.triangles, 0);
    EXPECT_GT(figures.worst, 0.95 * std::min(std::sin(angle), 0.6));
    EXPECT_LT(figures.longest, 1.6);
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, Slices, testing::Values(7, 11, 15, 20, 25, 30, 35, 40, 44));

TEST(AcuteCorners, SharperOnesThanSixDegreesAreFilledWhereNoTriangleIsWanted) {
  double angle = 3 * std::numbers::pi / 180;
  EXPECT_EQ(pave(slice(angle, 60), Elements::all_quad).triangles, 0);
}

TEST(AcuteCorners, AnOddLoopKeepsItsOneTriangle) { EXPECT_EQ(pave(slice(0.25, 21, false)).triangles, 1); }

TEST(AcuteCorners, BothEndsOfALensAreFilled) {
  std::vector<Vec2> loop;
  constexpr int n = 24;
  for (int i = 0; i < n; ++i) loop.push_back({static_cast<double>(i), -0.01 * i * (n - i)});
  for (int i = n; i > 0; --i) loop.push_back({static_cast<double>(i), 0.01 * i * (n - i)});
  Region region = planar_region({loop}, 1);
  Figures figures = pave(region);
  EXPECT_EQ(figures.triangles, 0);
  EXPECT_GT(figures.worst, 0.2);
}

TEST(AcuteCorners, ColumnsEndBeforeWhatReachesIntoThem) {
  Region region = slice(0.4, 20);
  std::vector<Vec2> points;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) points.push_back(node.p);
  std::size_t free_rows = 0;
  for (double hole : {100.0, 3.7, 1.2}) {
    SCOPED_TRACE(hole);
    points.push_back({hole, 0.3});
    RegionMesh mesh;
    std::vector<int> nodes;
    for (const LoopNode& node : region.loops[0])
      nodes.push_back(mesh.add_node(node.p, node.x, {1, 0, 0}, {0, 1, 0}, node.h));
    std::size_t before = nodes.size();
    lay_acute_corners(region, mesh, region.loops[0], nodes, points, 0.1);
    EXPECT_EQ(nodes.size() % 2, before % 2);
    const std::size_t rows = (before - nodes.size()) / 2;
    if (hole > 20) free_rows = rows;
    EXPECT_EQ(mesh.elements.empty(), hole < 2);  // one row is none
    EXPECT_TRUE(hole > 20 || rows < free_rows);
    for (const Element& e : mesh.elements)
      for (int v : e.v) EXPECT_LT(mesh.x[v].x, hole);
  }
}

/// Half of a body of revolution about the x axis, through points of its profile; with poles where they are on the axis.
Model half_of_revolution(const std::vector<Vec2>& profile) {
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, static_cast<int>(profile.size()));
  for (std::size_t i = 0; i < profile.size(); ++i)
    points->SetValue(static_cast<int>(i) + 1, gp_Pnt(profile[i].x, 0, profile[i].y));
  GeomAPI_Interpolate curve(points, false, 1e-9);
  curve.Perform();
  return test::model_of(
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(curve.Curve()), gp::OX(), std::numbers::pi).Shape());
}

test::PavedModel paved_half(const std::vector<Vec2>& profile, double h) {
  Options options;
  options.size = h;
  options.tip = 1;
  return {half_of_revolution(profile), options};
}

const std::vector<Vec2> spindle = {{0, 0},   {10, 12},   {30, 20},   {60, 23}, {120, 20}, {160, 13},
                                   {200, 9}, {250, 6.8}, {300, 6.4}, {340, 6}, {352, 0}};

TEST(AcuteCorners, PolesThatSurfacesTurnAboutHaveTwoQuadsOnEitherHalf) {
  const test::PavedModel half = paved_half(spindle, 18);
  ASSERT_EQ(half.paved.size(), 1U);
  const RegionMesh& mesh = half.paved[0];
  for (double end : {0.0, 352.0}) {
    int quads = 0, triangles = 0;
    for (const Element& e : mesh.elements)
      for (int k = 0; e.is_alive() && k < e.corners(); ++k)
        if (norm(mesh.x[e.v[k]] - Vec3{end, 0, 0}) < 1e-6) ++(e.corners() == 4 ? quads : triangles);
    EXPECT_EQ(quads, 2) << end;
    EXPECT_EQ(triangles, 0) << end;
  }
}

// The bottom of a drilled hole: its sides may be one element long, and then no ring fits before the rim.
TEST(AcuteCorners, HalvesOfShortConesAreMeshedAtEverySize) {
  for (double half_angle : {30.0, 45.0, 59.0, 70.0})
    for (double h = 0.3; h < 3; h *= 1.07) {
      SCOPED_TRACE(testing::Message() << half_angle << " degrees, size " << h);
      const double height = 1 / std::tan(half_angle * std::numbers::pi / 180);
      const test::PavedModel half = paved_half({{0, 0}, {height, 1}}, h);
      ASSERT_EQ(half.paved.size(), 1U);
      EXPECT_EQ(test::paved_faults(half.regions[0], half.paved[0]), "");
    }
}

TEST(AcuteCorners, ColumnsEndWhereTheSidesRunSideBySide) {
  const test::PavedModel half = paved_half(spindle, 18);
  const RegionMesh& mesh = half.paved[0];
  // About the thin part the surface turns by 180 degrees: no element by more than 70.
  for (const Element& e : mesh.elements)
    for (int k = 0; e.is_alive() && k < e.corners(); ++k) {
      const int a = e.v[k], b = e.v[(k + 1) % e.corners()];
      if (mesh.x[a].x < 200 || mesh.x[a].x > 300 || mesh.x[b].x < 200 || mesh.x[b].x > 300) continue;
      EXPECT_GT(dot(mesh.normal(a), mesh.normal(b)), std::cos(70 * std::numbers::pi / 180)) << mesh.x[a].x;
    }
}

}  // namespace
}  // namespace paver
