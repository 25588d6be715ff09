// Parts that do not touch are left alone, however near their boxes are; of those that do, what the kernel can fuse.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>
#include <numbers>

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

TEST(NearParts, SheetsAlongOneAnotherDoNotTouch) {
  const RunReport report = test::report_of(test::compound({dish(0), dish(1.5)}), 5);
  EXPECT_TRUE(report.model.unconnected.empty());
  EXPECT_STREQ(verdict(report), "sound");
}

/// One arm of two: a strip of width 0.8 that winds outwards, extruded; 0.77 apart from the turns of the other.
TopoDS_Shape spiral_arm(double phase) {
  constexpr int turns = 6, per_turn = 12, count = turns * per_turn + 1;
  auto side = [&](double radius) {
    TColgp_Array1OfPnt points(1, count);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / per_turn, r = radius + 0.5 * angle;
      points.SetValue(i + 1, gp_Pnt(r * std::cos(angle + phase), r * std::sin(angle + phase), 0));
    }
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge();
  };
  const TopoDS_Edge inner = side(3), outer = side(3.8);
  auto end_of = [](const TopoDS_Edge& edge, bool last) {
    return last ? TopExp::LastVertex(edge) : TopExp::FirstVertex(edge);
  };
  BRepBuilderAPI_MakeWire border(inner);
  border.Add(BRepBuilderAPI_MakeEdge(end_of(inner, true), end_of(outer, true)).Edge());
  border.Add(outer);
  border.Add(BRepBuilderAPI_MakeEdge(end_of(outer, false), end_of(inner, false)).Edge());
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(border.Wire(), true).Face(), gp_Vec(0, 0, 0.035)).Shape();
}

// The kernel would look for where they meet, for minutes.
TEST(NearParts, ArmsOfASpiralDoNotTouch) {
  const RunReport report = test::report_of(test::compound({spiral_arm(0), spiral_arm(std::numbers::pi)}), 4);
  EXPECT_TRUE(report.model.contacts.empty());
  EXPECT_EQ(report.components.size(), 2U);
  EXPECT_STREQ(verdict(report), "sound");
}

TEST(NearParts, SheetsThatCrossAreConnected) {
  const gp_Ax1 about(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  TColgp_Array1OfPnt points(1, 3);
  for (int i = 0; i < 3; ++i) points.SetValue(i + 1, gp_Pnt(2 + 14 * i, 0, 7 + 0.1 * i * i));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
  const TopoDS_Shape lid = BRepPrimAPI_MakeRevol(edge, about).Shape();
  const RunReport report = test::report_of(test::compound({dish(0), lid}), 5);
  EXPECT_EQ(report.model.contacts.size(), 1U);
  EXPECT_STREQ(verdict(report), "sound");
}

// The kernel follows such crossings for minutes.
TEST(NearParts, SheetsThatCrossAlmostAlongEachOtherAreNamed) {
  gp_Trsf tilt, aside;
  tilt.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 0.05);
  aside.SetTranslation(gp_Vec(1, 0, 0));
  const TopoDS_Shape tilted = dish(0).Moved(TopLoc_Location(aside * tilt));
  EXPECT_EQ(test::report_of(test::compound({dish(0), tilted}), 5).model.unconnected.size(), 1U);
}

/// Of side 20 about (x, 0, 0), as files of splines have planes.
TopoDS_Shape flat_spline(double x) {
  TColgp_Array2OfPnt poles(1, 2, 1, 2);
  for (int i : {1, 2})
    for (int j : {1, 2}) poles(i, j) = gp_Pnt(x + 20 * i - 30, 20 * j - 30, 0);
  return BRepBuilderAPI_MakeFace(GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles)), 1e-7).Face();
}

TEST(NearParts, FlatSplinesAreConnected) {
  const RunReport report = test::report_of(test::compound({flat_spline(0), flat_spline(10)}), 2);
  EXPECT_EQ(report.model.contacts.size(), 1U);
  EXPECT_NEAR(report.model.area, 600, 1e-6);
  EXPECT_STREQ(verdict(report), "sound");
}

TEST(NearParts, ACopyOfAFreeFormFaceIsMergedWithIt) {
  const RunReport report = test::report_of(test::compound({dish(0), dish(0)}), 5);
  EXPECT_TRUE(report.model.unconnected.empty());
  EXPECT_NEAR(report.quality.mesh_area, test::report_of(dish(0), 5).quality.mesh_area, 1);
}

/// The edge of a tube's side at z = 0.
TopoDS_Edge lower_rim(const TopoDS_Shape& side) {
  for (TopExp_Explorer edges(side, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    const gp_Pnt first = BRep_Tool::Pnt(TopExp::FirstVertex(edge)), last = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (std::abs(first.Z()) < 1e-9 && std::abs(last.Z()) < 1e-9) return edge;
  }
  return {};
}

// Faces of one sheet, as read: half a tube on a tube, whose lower rim both have.
TEST(NearParts, FacesThatLieOnOneAnotherFromACommonEdgeOnAreConnected) {
  const double round = 2 * std::numbers::pi;
  const Handle(Geom_Surface) around = new Geom_CylindricalSurface(gp_Ax3(), 10);
  const TopoDS_Face whole = BRepBuilderAPI_MakeFace(around, 0, round, 0, 20, 1e-7),
                    half = BRepBuilderAPI_MakeFace(around, 0, round, 0, 10, 1e-7);
  const TopoDS_Edge rim = lower_rim(whole), other = lower_rim(half);
  BRepTools_ReShape context;
  context.Replace(other, rim);
  context.Replace(TopExp::FirstVertex(other), TopExp::FirstVertex(rim));
  const TopoDS_Shape hung = context.Apply(half);
  ASSERT_TRUE(lower_rim(hung).IsSame(rim));
  const RunReport report = test::report_of(test::compound({whole, hung}), 2);
  EXPECT_NEAR(report.quality.mesh_area, round * 10 * 20, 2);
  EXPECT_STREQ(verdict(report), "sound");
}

}  // namespace
}  // namespace paver
