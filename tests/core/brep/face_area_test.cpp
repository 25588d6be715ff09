// Areas of faces whose borders are splines of many spans, on which the kernel's usual rule is percents off.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <cmath>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

/// The end of a wing: one spline through points that are dense at both ends, and a short line behind.
TopoDS_Face wing_end() {
  constexpr int half = 25;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 2 * half + 1);
  for (int i = -half; i <= half; ++i) {
    const double x = 0.5 * (1 - std::cos(std::numbers::pi * i / half));
    const double y =
        0.6 * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x - 0.1015 * x * x * x * x);
    points->SetValue(i + half + 1, {30 * x, i < 0 ? -30 * y : 30 * y, 0});
  }
  GeomAPI_Interpolate through(points, false, 1e-9);
  through.Perform();
  const gp_Pnt first = points->Value(1), last = points->Value(2 * half + 1);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(through.Curve()).Edge(),
                               BRepBuilderAPI_MakeEdge(last, first).Edge());
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

/// Bounded by one closed spline through a circle of radius 10, from just before its seam on.
TopoDS_Face disc(double before) {
  constexpr int count = 24;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points->SetValue(i + 1, {10 * std::cos(angle), 10 * std::sin(angle), 0});
  }
  GeomAPI_Interpolate through(points, true, 1e-9);
  through.Perform();
  const double first = through.Curve()->FirstParameter(), period = through.Curve()->Period();
  const double start = first + period * (1 - before);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(through.Curve(), start, start + period);
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire()).Face();
}

TEST(FaceArea, DoesNotDependOnWhereABorderBegins) {
  for (const double before : {0.5, 1e-3, 1e-9}) {
    const RunReport report = test::report_of(disc(before), 3);
    EXPECT_NEAR(report.quality.cad_area, 100 * std::numbers::pi, 0.05) << before;
    EXPECT_STREQ(verdict(report), "sound") << before;
  }
}

TEST(FaceArea, OfAWingsEndIsThatOfItsOutline) {
  const RunReport report = test::report_of(wing_end(), 2);
  // The polynomial's integral, 2 * 0.6 * 900 * 0.0686, up to what the spline differs between its points.
  const double area = 1.2 * 900 * (0.2969 / 1.5 - 0.126 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1015 / 5);
  EXPECT_NEAR(report.faces[0].cad_area, area, 1e-2 * area);
  EXPECT_STREQ(verdict(report), "sound") << report.faces[0].reason;
}

/// A strip of height 10 from a curve whose first span is a fortieth of its parameters.
TEST(FaceArea, OfAStripIsTheLengthOfItsCurveByItsHeight) {
  TColgp_Array1OfPnt poles(1, 6);
  const double heights[] = {0, 12, -9, 14, -6, 3};
  for (int i = 0; i < 6; ++i) poles.SetValue(i + 1, gp_Pnt(12 * i, heights[i], 0));
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger times(1, 4);
  const double at[] = {0, 0.025, 0.5, 1};
  for (int i = 0; i < 4; ++i) knots.SetValue(i + 1, at[i]), times.SetValue(i + 1, i == 0 || i == 3 ? 4 : 1);
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, times, 3);
  double length = 0;
  for (int i = 0; i < 20000; ++i) length += curve->Value(i / 20000.0).Distance(curve->Value((i + 1) / 20000.0));
  const TopoDS_Shape strip = BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(curve).Edge(), gp_Vec(0, 0, 10)).Shape();
  const RunReport report = test::report_of(strip, 4);
  EXPECT_NEAR(report.faces[0].cad_area, 10 * length, 2e-3 * 10 * length);
  EXPECT_STREQ(verdict(report), "sound") << report.faces[0].reason;
}

}  // namespace
}  // namespace paver
