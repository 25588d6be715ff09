// Waves and lobes that a line sweeps: lengths count their turns by a table whose lines are farther apart than these are
// wide, so rows that looked for their way had elements across them.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <string>

#include "brep/occt_shapes_impl.h"
#include "support/report_of.h"

namespace paver {
namespace {

template <class PointAt>
TopoDS_Edge spline_through(int count, bool is_closed, PointAt point_at) {
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) points->SetValue(i + 1, point_at(i));
  GeomAPI_Interpolate spline(points, is_closed, 1e-7);
  spline.Perform();
  return BRepBuilderAPI_MakeEdge(spline.Curve()).Edge();
}

TopoDS_Edge wave(double height, int periods) {
  return spline_through(41, false,
                        [&](int i) { return gp_Pnt(2.5 * i, height * std::sin(periods * 2 * M_PI * i / 40), 0); });
}

TopoDS_Edge lobes(double height, int count) {
  return spline_through(40, true, [&](int i) {
    const double angle = 2 * M_PI * i / 40, radius = 50 + height * std::sin(count * angle);
    return gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
}

void expect_rows_along_lines(const TopoDS_Shape& shape, double size) {
  SCOPED_TRACE(size);
  const RunReport report = test::report_of(shape, size);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.quality.triangles, 0);
  EXPECT_EQ(report.quality.irregular_nodes, 0);
  EXPECT_LT(report.quality.distance.largest, 0.025 * size);
}

TEST(SweptPrism, RowsOfSheetsFollowTheirWaves) {
  for (const double height : {12.0, 16.0, 20.0})
    for (const double size : {30.0, 18.0, 10.0, 5.0})
      expect_rows_along_lines(BRepPrimAPI_MakePrism(wave(height, 4), gp_Vec(0, 0, 100)).Shape(), size);
}

TEST(SweptPrism, RowsOfTubesFollowTheirLobes) {
  for (const double height : {8.0, 12.0})
    for (const double size : {30.0, 18.0, 10.0, 5.0})
      expect_rows_along_lines(BRepPrimAPI_MakePrism(lobes(height, 6), gp_Vec(0, 0, 100)).Shape(), size);
}

TEST(SweptPrism, MayHaveUnlikeStraightSides) {
  const TopoDS_Shape sheet = BRepPrimAPI_MakePrism(wave(16, 4), gp_Vec(0, 0, 100)).Shape();
  const auto edges = shapes_of(sheet, TopAbs_EDGE);
  int lines = 0;
  for (int i = 1; i <= edges.Extent(); ++i) {
    if (BRepAdaptor_Curve(TopoDS::Edge(edges(i))).GetType() != GeomAbs_Line) continue;
    Options options;
    options.size = 20;
    options.local = {{"Edge" + std::to_string(i), 14}};
    const RunReport report = test::mesh_of(sheet, options).report;
    EXPECT_EQ(report.quality.irregular_nodes, 0);
    EXPECT_LT(report.quality.distance.largest, 0.025 * 20);
    ++lines;
  }
  EXPECT_EQ(lines, 2);
}

// Of a mast whose ends have short facets the rest is as coarse as asked for.
TEST(SweptPrism, ShortFacetsAtTheEndsDoNotRunThroughALongOne) {
  const TopoDS_Edge rim = lobes(6, 5);
  Options options;
  options.size = 40;
  const long coarse =
      test::mesh_of(BRepPrimAPI_MakePrism(rim, gp_Vec(0, 0, 2000)).Shape(), options).report.quality.quads;
  options.local = {{"Edge2", 3}, {"Edge3", 3}};
  const long fine = test::mesh_of(BRepPrimAPI_MakePrism(rim, gp_Vec(0, 0, 2000)).Shape(), options).report.quality.quads;
  EXPECT_LT(fine, 5 * coarse);
}

}  // namespace
}  // namespace paver
