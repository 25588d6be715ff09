// Planes, cylinders, cones, spheres and tori that files give as swept surfaces or splines are what they are.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>
#include <vector>

#include "brep/connecting/workpiece_impl.h"
#include "brep/surfaces/surface.h"
#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::model_of;
using test::report_of;

const gp_Ax1 axis(gp_Pnt(3, -2, 1), gp_Dir(1, 2, 2));
const gp_Dir out(2, -2, 1);  // at a right angle to it

gp_Pnt at(double radius, double height) {
  return axis.Location().Translated(gp_Vec(out) * radius + gp_Vec(axis.Direction()) * height);
}

/// The surface that a face has in the model, and that the model covers what the face does, on the same side.
SurfaceKind kind_of(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Face();
  const Model model = model_of(face);
  EXPECT_EQ(model.faces.size(), 1U);
  EXPECT_TRUE(model.report.repairs.empty());
  EXPECT_EQ(model.faces[0].fault, "");
  EXPECT_NEAR(model.faces[0].area, face_area(face), 1e-6 * face_area(face));
  return model.faces[0].surface->kind();
}

constexpr double turn = 2 * std::numbers::pi;

TEST(Recognise, TurnedLines) {
  for (double way : {1.0, -1.0}) {
    gp_Ax1 about = axis;
    if (way < 0) about.Reverse();
    for (double u1 : {1.0, turn}) {
      const gp_Dir along(gp_Vec(axis.Direction()) * way);
      const Handle(Geom_Line) parallel = new Geom_Line(at(4, 0), along);
      EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(parallel, about), 0, u1, -2, 5), SurfaceKind::cylinder);
      EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(parallel, axis), 0, u1, -2, 5), SurfaceKind::cylinder);
      const gp_Dir oblique(gp_Vec(along) + 0.4 * gp_Vec(out));
      const Handle(Geom_Line) slant = new Geom_Line(at(4, 0), oblique);
      EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(slant, about), 0, u1, -2, 5), SurfaceKind::cone);
      const Handle(Geom_Line) from_apex = new Geom_Line(at(0, 2), oblique);
      EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(from_apex, axis), 0, u1, 1, 5), SurfaceKind::cone);
      EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(from_apex, axis), 0, u1, 0, 5), SurfaceKind::cone);
    }
  }
  // Past the axis it makes a hyperboloid.
  const Handle(Geom_Line) skew = new Geom_Line(at(4, 0), gp_Dir(gp_Vec(axis.Direction()) + gp_Vec(gp_Dir(2, 1, -2))));
  EXPECT_EQ(kind_of(new Geom_SurfaceOfRevolution(skew, axis), 0, 1, -2, 5), SurfaceKind::other);
}

TEST(Recognise, TurnedCircles) {
  const gp_Dir across = axis.Direction().Crossed(out);
  for (const gp_Dir& normal : {across, across.Reversed()})
    for (double start : {0.0, 2.0, 5.0}) {
      auto circle = [&](double distance) {
        gp_Ax2 axes(at(distance, 3), normal, out);
        axes.Rotate(gp_Ax1(axes.Location(), normal), -start);
        return new Geom_Circle(axes, 2);
      };
      // by the angle from the equator
      auto kind = [&](double distance, double u1, double from, double to) {
        return kind_of(new Geom_SurfaceOfRevolution(circle(distance), axis), 0, u1, start + from, start + to);
      };
      EXPECT_EQ(kind(0, turn, -1, 0.7), SurfaceKind::sphere);
      EXPECT_EQ(kind(0, 1.5, -1, 0.7), SurfaceKind::sphere);
      EXPECT_EQ(kind(6, turn, -1, 2.5), SurfaceKind::torus);
      EXPECT_EQ(kind(6, 1.5, -1, 2.5), SurfaceKind::torus);
      EXPECT_EQ(kind(1, 1.5, -1, 0.7), SurfaceKind::other);  // it runs through itself
    }
}

TEST(Recognise, Extrusions) {
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(at(4, 1), axis.Direction(), out), 2);
  for (const gp_Dir& along : {axis.Direction(), axis.Direction().Reversed()})
    EXPECT_EQ(kind_of(new Geom_SurfaceOfLinearExtrusion(circle, along), 0.5, 4, 1, 3), SurfaceKind::cylinder);
  EXPECT_EQ(kind_of(new Geom_SurfaceOfLinearExtrusion(circle, gp_Dir(1, 2, 3)), 0.5, 4, 1, 3), SurfaceKind::other);
  const Handle(Geom_Line) line = new Geom_Line(at(4, 1), out);
  EXPECT_EQ(kind_of(new Geom_SurfaceOfLinearExtrusion(line, gp_Dir(1, 2, 3)), 0.5, 4, 1, 3), SurfaceKind::plane);
}

TEST(Recognise, SplinesThatAreNearlyCylindersStaySplines) {
  const Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(axis.Location(), axis.Direction(), out), 4);
  const Handle(Geom_BSplineSurface) spline =
      GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(cylinder, 0.2, 1.9, 1.0, 7.0));
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  spline->Bounds(u0, u1, v0, v1);
  EXPECT_EQ(kind_of(spline, u0, u1, v0, v1), SurfaceKind::cylinder);
  spline->SetPole(2, 1, spline->Pole(2, 1).Translated(gp_Vec(0, 0, 1e-4)));
  EXPECT_EQ(kind_of(spline, u0, u1, v0, v1), SurfaceKind::other);
}

/// A plate with pins and funnels on it, `count` of each, placed copies of one.
std::vector<TopoDS_Shape> pins_on_plate(int count, bool is_spline) {
  auto written = [&](const TopoDS_Shape& shape) {
    return is_spline ? BRepBuilderAPI_NurbsConvert(shape).Shape() : shape;
  };
  const TopoDS_Shape pin = written(BRepPrimAPI_MakeCylinder(2, 6).Shape());
  const TopoDS_Shape funnel = written(BRepPrimAPI_MakeCone(1, 3, 4).Shape());
  std::vector<TopoDS_Shape> parts = {written(BRepPrimAPI_MakeBox(gp_Pnt(-6, -6, -2), 12.0 * count, 24, 2).Shape())};
  for (int i = 0; i < count; ++i) {
    gp_Trsf place;
    place.SetTranslation(gp_Vec(12.0 * i, 0, 0));
    parts.push_back(pin.Located(TopLoc_Location(place)));
    place.SetTranslation(gp_Vec(12.0 * i, 11, 0));
    parts.push_back(funnel.Located(TopLoc_Location(place)));
  }
  return parts;
}

TEST(Recognise, AssembliesOfSplinesConnectAsTheOnesTheyAre) {
  const TopoDS_Shape exact = compound(pins_on_plate(3, false)), splines = compound(pins_on_plate(3, true));
  const Model model = model_of(splines), expected = model_of(exact);
  ASSERT_EQ(model.faces.size(), expected.faces.size());
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    if (!model.faces[i].surface) continue;
    EXPECT_EQ(model.faces[i].surface->kind(), expected.faces[i].surface->kind()) << model.faces[i].name;
    EXPECT_NEAR(model.faces[i].area, expected.faces[i].area, 1e-6 * expected.faces[i].area) << model.faces[i].name;
  }
  EXPECT_EQ(model.report.contacts.size(), expected.report.contacts.size());
  const RunReport report = report_of(splines, 1), wanted = report_of(exact, 1);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_NEAR(report.quality.quads, wanted.quality.quads, 0.02 * wanted.quality.quads);
  EXPECT_NEAR(report.quality.mesh_area, wanted.quality.mesh_area, 1e-6 * wanted.quality.mesh_area);
}

}  // namespace
}  // namespace paver
