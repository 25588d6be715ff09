// Writes the example models of Resources/examples:  paver_make_shapes FOLDER
// Lengths in mm. What each model is for: Resources/examples/README.md.
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <GC_MakeSegment.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <cstdio>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <string>
#include <utility>
#include <vector>

#include "support/wind_generator.h"

namespace {

const double pi = std::acos(-1.0);
const gp_Ax1 x_axis(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0));

TopoDS_Wire rectangle(double width, double height) {
  double x = width / 2, y = height / 2;
  return BRepBuilderAPI_MakePolygon(gp_Pnt(-x, -y, 0), gp_Pnt(x, -y, 0), gp_Pnt(x, y, 0), gp_Pnt(-x, y, 0), true);
}

TopoDS_Wire circle(double x, double y, double radius) {
  gp_Circ c(gp_Ax2(gp_Pnt(x, y, 0), gp_Dir(0, 0, 1)), radius);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(c));
}

/// Planar face inside `outer`, without the insides of `holes`.
TopoDS_Face plate(const TopoDS_Wire& outer, const std::vector<TopoDS_Wire>& holes) {
  BRepBuilderAPI_MakeFace face(outer, true);
  for (const TopoDS_Wire& hole : holes) face.Add(TopoDS::Wire(hole.Reversed()));
  return face;
}

TopoDS_Face plate_nine_holes() {
  std::vector<TopoDS_Wire> holes;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) holes.push_back(circle(60 * i, 60 * j, 5));
  }
  return plate(rectangle(200, 200), holes);
}

/// Cone from its tip at x = 0 to a sphere of `radius` that it touches; half angle in radians.
struct ConeSphere {
  double radius, half_angle;
  double center() const { return radius / std::sin(half_angle); }
  gp_Pnt tip() const { return {0, 0, 0}; }
  gp_Pnt back() const { return {center() + radius, 0, 0}; }
  /// On the sphere, at `angle` from the direction towards the tip.
  gp_Pnt at(double angle) const { return {center() - radius * std::cos(angle), radius * std::sin(angle), 0}; }
  gp_Pnt touch() const { return at(pi / 2 - half_angle); }
  Handle(Geom_TrimmedCurve) line() const { return GC_MakeSegment(tip(), touch()).Value(); }
  Handle(Geom_TrimmedCurve) arc() const { return GC_MakeArcOfCircle(touch(), at(0.7 * pi), back()).Value(); }
};

/// The solid that `profile`, an open chain from axis to axis, sweeps around x.
TopoDS_Shape revolve(const TopoDS_Shape& profile) {
  TopoDS_Shape swept = BRepPrimAPI_MakeRevol(profile, x_axis);
  BRepBuilderAPI_Sewing sewing(1e-6);
  sewing.Add(swept);
  sewing.Perform();
  TopoDS_Shape sewn = sewing.SewedShape();
  TopoDS_Shell shell;
  if (sewn.ShapeType() == TopAbs_FACE) {  // one face: nothing to sew
    BRep_Builder().MakeShell(shell);
    BRep_Builder().Add(shell, sewn);
    shell.Closed(true);
  } else {
    shell = TopoDS::Shell(sewn);
  }
  return BRepBuilderAPI_MakeSolid(shell);
}

TopoDS_Shape conesphere_one_face() {
  ConeSphere c{50, pi / 15};
  GeomConvert_CompCurveToBSplineCurve profile(c.line());
  profile.Add(c.arc(), 1e-6);
  return revolve(BRepBuilderAPI_MakeEdge(profile.BSplineCurve()));
}

TopoDS_Shape conesphere() {
  ConeSphere c{50, pi / 15};
  BRepBuilderAPI_MakeWire profile(BRepBuilderAPI_MakeEdge(c.line()), BRepBuilderAPI_MakeEdge(c.arc()));
  return revolve(profile.Wire());
}

/// Cone-sphere with a square groove where cone and sphere meet.
TopoDS_Shape conesphere_gap() {
  ConeSphere c{50, pi / 15};
  double gap = 6;
  gp_Pnt a = c.touch(), b(a.X(), a.Y() - gap, 0), e = c.at(pi / 2 - c.half_angle + 2 * std::asin(gap / 2 / c.radius));
  gp_Pnt d(e.X(), b.Y(), 0);
  BRepBuilderAPI_MakeWire profile;
  for (auto [from, to] : {std::pair{c.tip(), a}, {a, b}, {b, d}, {d, e}}) {
    profile.Add(BRepBuilderAPI_MakeEdge(from, to));
  }
  profile.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(e, c.at(0.75 * pi), c.back()).Value()));
  return revolve(profile.Wire());
}

TopoDS_Shape box_cylinder() {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-60, -40, 0), gp_Pnt(60, 40, 40));
  TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 0, 0), gp_Dir(0, 0, 1)), 25, 100);
  ShapeUpgrade_UnifySameDomain unify(BRepAlgoAPI_Fuse(box, cylinder).Shape());
  unify.Build();
  return unify.Shape();
}

TopoDS_Shape wavy_patch() {
  const int n = 13;
  TColgp_Array2OfPnt points(1, n, 1, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      double s = i / (n - 1.0), t = j / (n - 1.0);
      double x = 240 * s + 12 * std::sin(2 * pi * t), y = 180 * t - 15 * std::sin(pi * s);
      points(i + 1, j + 1) = gp_Pnt(x, y, 22 * std::sin(2 * pi * s) * std::cos(1.5 * pi * t) + 14 * t * t);
    }
  }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-6);
}

/// Wing section of a symmetric profile, open by `gap` chords at the trailing edge: upper side, end, lower side.
TopoDS_Wire wing_section(gp_Pnt nose, double chord, double thickness, double gap) {
  const int n = 25;
  TColgp_Array1OfPnt upper(1, n), lower(1, n);
  for (int i = 0; i < n; ++i) {
    double s = 0.5 * (1 - std::cos(pi * i / (n - 1)));
    double y = 5 * thickness *
               (0.2969 * std::sqrt(s) - 0.1260 * s - 0.3516 * s * s + 0.2843 * s * s * s - 0.1036 * s * s * s * s);
    y += 0.5 * gap * s;
    upper(n - i) = gp_Pnt(nose.X() + s * chord, nose.Y(), nose.Z() + y * chord);
    lower(i + 1) = gp_Pnt(nose.X() + s * chord, nose.Y(), nose.Z() - y * chord);
  }
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(upper).Curve()));
  wire.Add(BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(lower).Curve()));
  wire.Add(BRepBuilderAPI_MakeEdge(lower(n), upper(1)));
  return wire;
}

TopoDS_Shape wing() {
  BRepOffsetAPI_ThruSections loft(true, true);
  loft.AddWire(wing_section(gp_Pnt(0, 0, 0), 200, 0.14, 0.008));
  loft.AddWire(wing_section(gp_Pnt(90, 400, 30), 80, 0.10, 0.012));
  loft.Build();
  return loft.Shape();
}

TopoDS_Shape pyramid() {
  const gp_Pnt top(0, 0, 80);
  const std::vector<gp_Pnt> base{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}};
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (std::size_t i = 0; i < base.size(); ++i) {
    sewing.Add(BRepBuilderAPI_MakeFace(
        BRepBuilderAPI_MakePolygon(base[i], base[(i + 1) % base.size()], top, true).Wire(), true));
  }
  sewing.Add(BRepBuilderAPI_MakeFace(rectangle(100, 100), true).Shape().Reversed());
  sewing.Perform();
  return BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
}

void write(const TopoDS_Shape& shape, const std::string& path) {
  if (shape.IsNull() || !BRepCheck_Analyzer(shape).IsValid()) throw Standard_Failure("not a valid shape");
  if (path.ends_with(".brep")) {
    if (!BRepTools::Write(shape, path.c_str())) throw Standard_Failure("not written");
    return;
  }
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) throw Standard_Failure("not written");
}

std::vector<std::pair<std::string, TopoDS_Shape>> shapes() {
  return {{"plate_rect_hole.step", plate(rectangle(300, 200), {rectangle(120, 60)})},
          {"plate_circular_hole.step", plate(rectangle(200, 200), {circle(0, 0, 40)})},
          {"plate_nine_holes.step", plate_nine_holes()},
          {"disk_tiny_hole.step", plate(circle(0, 0, 100), {circle(0, 0, 1)})},
          {"conesphere_one_face.brep", conesphere_one_face()},
          {"conesphere.step", conesphere()},
          {"conesphere_gap.step", conesphere_gap()},
          {"sphere.step", BRepPrimAPI_MakeSphere(100)},
          {"torus.step", BRepPrimAPI_MakeTorus(100, 35)},
          {"box.step", BRepPrimAPI_MakeBox(100, 60, 40)},
          {"box_cylinder.step", box_cylinder()},
          {"pyramid.step", pyramid()},
          {"wavy_patch.step", wavy_patch()},
          {"wing.step", wing()},
          {"wind_generator.brep", wind_generator()}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: paver_make_shapes FOLDER\n");
    return 2;
  }
  try {
    for (const auto& [name, shape] : shapes()) {
      write(shape, std::string(argv[1]) + "/" + name);
      std::printf("%s\n", name.c_str());
    }
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "paver_make_shapes: %s\n", failure.GetMessageString());
    return 1;
  }
  return 0;
}
