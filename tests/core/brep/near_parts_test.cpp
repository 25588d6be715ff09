// Parts that do not touch are left alone, however near their boxes are.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax1.hxx>

#include "support/report_of.h"

namespace paver {
namespace {

/// Of a parabola about the z axis, z = height + r^2 / 60 from r = 2 to 30.
TopoDS_Shape dish(double height) {
  constexpr int count = 12;
  TColgp_Array1OfPnt points(1, count);
  for (int i = 1; i <= count; ++i) {
    const double r = 2 + 28.0 * (i - 1) / (count - 1);
    points.SetValue(i, gp_Pnt(r, 0, height + r * r / 60));
  }
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
  return BRepPrimAPI_MakeRevol(edge, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

TopoDS_Shape together(const TopoDS_Shape& one, const TopoDS_Shape& two) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  builder.Add(compound, one);
  builder.Add(compound, two);
  return compound;
}

TEST(NearParts, SheetsAlongOneAnotherDoNotTouch) {
  const RunReport report = test::report_of(together(dish(0), dish(1.5)), 5);
  EXPECT_TRUE(report.model.unconnected.empty());
  EXPECT_STREQ(verdict(report), "sound");
}

TEST(NearParts, SheetsThatCrossAreNamed) {
  const gp_Ax1 about(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  TColgp_Array1OfPnt points(1, 3);
  for (int i = 0; i < 3; ++i) points.SetValue(i + 1, gp_Pnt(2 + 14 * i, 0, 7 + 0.1 * i * i));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
  const TopoDS_Shape lid = BRepPrimAPI_MakeRevol(edge, about).Shape();
  EXPECT_EQ(test::report_of(together(dish(0), lid), 5).model.unconnected.size(), 1U);
}

}  // namespace
}  // namespace paver
