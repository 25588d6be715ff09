// Four square patches about a point, of which two come apart from there on: sewn where that can be, told where not.
#include "check/distance/cracks.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

TopoDS_Face polygon(std::initializer_list<gp_Pnt> corners) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& corner : corners) outline.Add(corner);
  outline.Close();
  return BRepBuilderAPI_MakeFace(outline.Wire()).Face();
}

/// Of side 10 about (10, 10, 0); the upper two end `gap` apart at y = 20.
std::vector<TopoDS_Shape> patches_of(double gap) {
  return {polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}),
          polygon({{10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0}}),
          polygon({{0, 10, 0}, {10, 10, 0}, {10 - gap, 20, 0}, {0, 20, 0}}),
          polygon({{10, 10, 0}, {20, 10, 0}, {20, 20, 0}, {10, 20, 0}})};
}

TopoDS_Shape patches(double gap) { return test::compound(patches_of(gap)); }

RunReport report_of(const TopoDS_Shape& shape, std::optional<double> sew_tolerance = {}) {
  Options options;
  options.size = 3;
  options.sew_tolerance = sew_tolerance;
  return test::mesh_of(shape, options).report;
}

TEST(Cracks, ThatOpenFromAVertexOnAreSewn) {
  for (double gap : {1e-5, 1e-3, 2e-2}) {
    const RunReport report = report_of(patches(gap));
    EXPECT_EQ(report.model.free_edges, 8) << gap;
    EXPECT_STREQ(verdict(report), "sound") << gap;
  }
}

TEST(Cracks, AreToldWhereTheyStay) {
  const RunReport report = report_of(patches(1e-3), 1e-5);
  ASSERT_EQ(report.gaps.size(), 1U);
  EXPECT_EQ(report.gaps[0].parts[0], report.gaps[0].parts[1]);
  EXPECT_NEAR(report.gaps[0].distance, 1e-3, 1e-4);
  EXPECT_GT(report.gaps[0].where.y, 19);
  EXPECT_STREQ(verdict(report), "doubtful");
}

// The left side of the crack has a wall, so that only its right side is free.
TEST(Cracks, BesideAnEdgeOfTwoFacesAreTold) {
  const double gap = 1e-3;
  std::vector<TopoDS_Shape> faces = patches_of(gap);
  faces.push_back(polygon({{10, 10, 0}, {10 - gap, 20, 0}, {10 - gap, 20, 5}, {10, 10, 5}}));
  const RunReport report = report_of(test::compound(faces), 1e-5);
  ASSERT_EQ(report.gaps.size(), 1U);
  EXPECT_NEAR(report.gaps[0].distance, gap, 1e-4);
  EXPECT_STREQ(verdict(report), "doubtful");
}

TEST(Cracks, StripsAreNone) {
  const RunReport report = report_of(polygon({{0, 0, 0}, {60, 0, 0}, {60, 1e-3, 0}, {0, 1e-3, 0}}));
  EXPECT_TRUE(report.gaps.empty());
}

TEST(Cracks, NotchesAreNone) {
  const RunReport report = report_of(patches(1));
  EXPECT_EQ(report.model.free_edges, 10);
  EXPECT_STREQ(verdict(report), "sound");
}

}  // namespace
}  // namespace paver
