// Areas of faces whose borders are splines of many spans, on which the kernel's usual rule is percents off.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
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

TEST(FaceArea, OfAWingsEndIsThatOfItsOutline) {
  const RunReport report = test::report_of(wing_end(), 2);
  // The polynomial's integral, 2 * 0.6 * 900 * 0.0686, up to what the spline differs between its points.
  const double area = 1.2 * 900 * (0.2969 / 1.5 - 0.126 / 2 - 0.3516 / 3 + 0.2843 / 4 - 0.1015 / 5);
  EXPECT_NEAR(report.faces[0].cad_area, area, 1e-2 * area);
  EXPECT_STREQ(verdict(report), "sound") << report.faces[0].reason;
}

}  // namespace
}  // namespace paver
