// Areas of faces by their borders, where mathematics has them too.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom2d_Circle.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>

#include "brep/connecting/workpiece_impl.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double third =
    2 * pi / 3;  // of a turn: one span of the kernel's splines, whose ends lie where the angle has them
constexpr double share = 1e-6;

TopoDS_Face face_of(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
  return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
}

/// z = bend x y over |x| <= 1, |y| <= 1, in a number of spans either way.
Handle(Geom_BSplineSurface) saddle(double bend, int spans) {
  TColgp_Array2OfPnt poles(1, spans + 1, 1, spans + 1);
  TColStd_Array1OfReal knots(1, spans + 1);
  TColStd_Array1OfInteger times(1, spans + 1);
  times.Init(1);
  times(1) = times(spans + 1) = 2;
  auto at = [&](int i) { return 2.0 * (i - 1) / spans - 1; };
  for (int i = 1; i <= spans + 1; ++i) {
    knots(i) = at(i);
    for (int j = 1; j <= spans + 1; ++j) poles(i, j) = gp_Pnt(at(i), at(j), bend * at(i) * at(j));
  }
  return new Geom_BSplineSurface(poles, knots, knots, times, times, 1, 1);
}

/// Of the saddle about its middle.
double disc_area(double bend, double radius) {
  return 2 * pi / 3 * (std::pow(1 + bend * bend * radius * radius, 1.5) - 1) / (bend * bend);
}

/// About (0, 0), from the angle `begin` on.
TopoDS_Wire circle_on(const Handle(Geom_Surface) & surface, double radius, double begin = 0) {
  const gp_Ax2d axis({}, {std::cos(begin), std::sin(begin)});
  const Handle(Geom2d_Circle) circle = new Geom2d_Circle(axis, radius);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(circle, surface).Edge();
  BRepLib::BuildCurve3d(edge);
  return BRepBuilderAPI_MakeWire(edge).Wire();
}

TEST(BorderArea, OfASphereWithPolesAndOfItsParts) {
  const Handle(Geom_BSplineSurface) sphere =
      GeomConvert::SurfaceToBSplineSurface(new Geom_SphericalSurface(gp_Ax3(), 5));
  const double whole = 100 * pi;
  EXPECT_NEAR(face_area(face_of(sphere, 0, 2 * pi, -pi / 2, pi / 2)), whole, share * whole);
  EXPECT_NEAR(face_area(face_of(sphere, 0, third, 0, pi / 2)), whole / 6, share * whole);
  const TopoDS_Face over_seam = face_of(sphere, 2 * third, 4 * third, 0, pi / 2);
  EXPECT_NEAR(face_area(over_seam), whole / 3, share * whole);
  EXPECT_EQ(face_area(TopoDS::Face(over_seam.Reversed())), face_area(over_seam));
}

TEST(BorderArea, OfATorusThatIsPeriodicBothWays) {
  const Handle(Geom_BSplineSurface) torus =
      GeomConvert::SurfaceToBSplineSurface(new Geom_ToroidalSurface(gp_Ax3(), 7, 2));
  const double whole = 4 * pi * pi * 14;
  EXPECT_NEAR(face_area(face_of(torus, 0, 2 * pi, 0, 2 * pi)), whole, share * whole);
  EXPECT_NEAR(face_area(face_of(torus, 2 * third, 4 * third, 0, 2 * pi)), whole * 2 / 3, share * whole);
  const double outer = third * 2 * (7 * 2 * third + 2 * 2 * std::sin(third));  // a third of the turn, two of the tube
  EXPECT_NEAR(face_area(face_of(torus, 2 * third, 3 * third, 2 * third, 4 * third)), outer, share * whole);
}

TEST(BorderArea, OfDiscsAndWhatTheyLeaveOfASaddle) {
  const double bend = 3;
  double whole = 0;
  constexpr int strips = 2000;
  for (int i = 0; i < strips; ++i)
    for (int j = 0; j < strips; ++j)
      whole += std::sqrt(1 + bend * bend * (std::pow((i + 0.5) / strips, 2) + std::pow((j + 0.5) / strips, 2)));
  whole *= 4.0 / strips / strips;
  for (const int spans : {1, 7, 40}) {
    const Handle(Geom_BSplineSurface) surface = saddle(bend, spans);
    EXPECT_NEAR(face_area(BRepBuilderAPI_MakeFace(surface, 1e-7).Face()), whole, share * whole);
    for (const double radius : {0.001, 0.3, 0.8}) {
      const double area = disc_area(bend, radius);
      EXPECT_NEAR(face_area(BRepBuilderAPI_MakeFace(surface, circle_on(surface, radius)).Face()), area, share * area);
      BRepBuilderAPI_MakeFace holed(surface, 1e-7);
      holed.Add(TopoDS::Wire(circle_on(surface, radius).Reversed()));
      EXPECT_NEAR(face_area(holed.Face()), whole - area, share * whole) << spans << " " << radius;
    }
  }
}

TEST(BorderArea, OfADiscWhereverItsCircleBegins) {
  const Handle(Geom_Surface) plane = new Geom_Plane(gp_Ax3());
  for (const double begin : {0.3, 1.06, 2.0, 5.9})
    EXPECT_NEAR(face_area(BRepBuilderAPI_MakeFace(plane, circle_on(plane, 10, begin)).Face()), 100 * pi,
                share * 100 * pi);
}

TEST(BorderArea, OfARoofIsThatOfItsPlanes) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 0), poles(2) = gp_Pnt(3, 4, 0), poles(3) = gp_Pnt(6, 0, 0), poles(4) = gp_Pnt(6, -1e-3, 0);
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger times(1, 4);
  times.Init(1);
  times(1) = times(4) = 2;
  knots(1) = 0, knots(2) = 0.01, knots(3) = 0.7, knots(4) = 10;
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(new Geom_BSplineCurve(poles, knots, times, 1)).Edge();
  const TopoDS_Shape roof = BRepPrimAPI_MakePrism(edge, gp_Vec(0, 0, 8)).Shape();
  EXPECT_NEAR(face_area(TopoDS::Face(roof)), 8 * 10.001, share * 80);
}

}  // namespace
}  // namespace paver
