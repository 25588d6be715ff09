// Tower (cone), nacelle (rounded box), shaft (cylinder), spinner (revolved) and blades (lofts), joined to one solid.
#include "support/wind_generator.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfEllipse.hxx>
#include <GeomFill.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_Trsf.hxx>
#include <iterator>

namespace {

const double pi = std::acos(-1.0);

// All lengths in mm, angles in radians.
constexpr double hub_height = 24800;
constexpr double tower_foot = 1000, tower_top = 600, tower_height = 24200;
constexpr double nacelle_front = -1300, nacelle_length = 4200, nacelle_width = 1800, nacelle_rounding = 350;
constexpr double shaft_radius = 520;
constexpr double spinner_back = -1500, spinner_radius = 780, spinner_collar = 1100, spinner_nose = 1300;
constexpr double rotor_plane = -2050;

/// A blade section: `radius` from the rotor's axis; `profile` 0: a circle of diameter `chord`, 1: an aerofoil.
struct Section {
  double radius, chord, thickness, twist, profile;
};
const Section sections[] = {{500, 560, 1, 0.26, 0},      {1200, 560, 1, 0.26, 0},    {1900, 760, 0.62, 0.26, 0.6},
                            {2800, 1080, 0.32, 0.24, 1}, {4600, 930, 0.24, 0.15, 1}, {7000, 700, 0.19, 0.08, 1},
                            {9400, 500, 0.16, 0.035, 1}, {11500, 320, 0.14, 0.01, 1}};

/// Half thickness over the chord at `s` of the chord: four-digit profile with an open trailing edge.
double half_thickness(const Section& c, double s) {
  double wing = 5 * c.thickness *
                (0.2969 * std::sqrt(s) - 0.1260 * s - 0.3516 * s * s + 0.2843 * s * s * s - 0.1036 * s * s * s * s);
  double circle = c.thickness * std::sqrt(s * (1 - s));
  double edge = 12 / c.chord * s;  // the blunt trailing edge is 24 mm thick
  return (1 - c.profile) * circle + c.profile * wing + edge;
}

/// Point of a section; the chord's fore part is on the blade's axis, which is z. `side` is 1 or -1.
gp_Pnt section_point(const Section& c, double s, int side) {
  double axis = 0.5 - 0.2 * c.profile;  // pitch axis, of the chord
  double along = (s - axis) * c.chord, across = side * half_thickness(c, s) * c.chord;
  return {along * std::sin(c.twist) + across * std::cos(c.twist),
          along * std::cos(c.twist) - across * std::sin(c.twist), c.radius};
}

/// Knots of a clamped cubic B-spline of `poles` poles, each a whole number, and their multiplicities.
void clamped_knots(int poles, TColStd_Array1OfReal& knots, TColStd_Array1OfInteger& multiplicities) {
  for (int i = 1; i <= poles - 2; ++i) {
    knots(i) = i - 1;
    multiplicities(i) = i == 1 || i == poles - 2 ? 4 : 1;
  }
}

/// Surface with the sections' points as poles: u from the trailing edge over the upper side to the nose and back below,
/// v outwards. Planes of the first and last section are kept.
Handle(Geom_BSplineSurface) blade_skin() {
  const int n = 8, around = 2 * n + 1, along = static_cast<int>(std::size(sections));
  TColgp_Array2OfPnt poles(1, around, 1, along);
  for (int j = 0; j < along; ++j) {
    for (int i = -n; i <= n; ++i) {
      double s = 0.5 * (1 - std::cos(pi * i / n));
      poles(i + n + 1, j + 1) = section_point(sections[j], s, i < 0 ? 1 : -1);
    }
  }
  TColStd_Array1OfReal u(1, around - 2), v(1, along - 2);
  TColStd_Array1OfInteger u_multiplicity(1, around - 2), v_multiplicity(1, along - 2);
  clamped_knots(around, u, u_multiplicity);
  clamped_knots(along, v, v_multiplicity);
  return new Geom_BSplineSurface(poles, u, v, u_multiplicity, v_multiplicity, 3, 3);
}

/// Plane face between the skin's curve at `v`, in a plane across the blade, and the trailing edge.
TopoDS_Face blade_end(const Handle(Geom_BSplineSurface) & skin, double v) {
  Handle(Geom_Curve) around = skin->VIso(v);
  gp_Pnt from = around->Value(around->FirstParameter()), to = around->Value(around->LastParameter());
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(around), BRepBuilderAPI_MakeEdge(to, from));
  return BRepBuilderAPI_MakeFace(wire.Wire(), true);
}

/// The blade that points up, its axis through the origin: two sides, trailing edge, tip, and an end in the spinner.
TopoDS_Shape blade() {
  Handle(Geom_BSplineSurface) skin = blade_skin();
  double u0, u1, v0, v1;
  skin->Bounds(u0, u1, v0, v1);
  double nose = 0.5 * (u0 + u1);
  BRepBuilderAPI_Sewing sewing(1e-3);
  sewing.Add(BRepBuilderAPI_MakeFace(skin, u0, nose, v0, v1, 1e-6));
  sewing.Add(BRepBuilderAPI_MakeFace(skin, nose, u1, v0, v1, 1e-6));
  sewing.Add(BRepBuilderAPI_MakeFace(GeomFill::Surface(skin->UIso(u0), skin->UIso(u1)), 1e-6));
  sewing.Add(blade_end(skin, v0));
  sewing.Add(blade_end(skin, v1));
  sewing.Perform();
  if (sewing.SewedShape().ShapeType() != TopAbs_SHELL) throw Standard_Failure("a blade is not closed");
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(TopoDS::Shell(sewing.SewedShape()));
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

TopoDS_Shape spinner() {
  gp_Pnt back(spinner_back, 0, hub_height), rim(spinner_back, 0, hub_height + spinner_radius);
  double front = spinner_back - spinner_collar;
  gp_Pnt shoulder(front, 0, hub_height + spinner_radius), nose(front - spinner_nose, 0, hub_height);
  gp_Elips ellipse(gp_Ax2(gp_Pnt(front, 0, hub_height), gp_Dir(0, 1, 0), gp_Dir(-1, 0, 0)), spinner_nose,
                   spinner_radius);
  BRepBuilderAPI_MakeWire profile(BRepBuilderAPI_MakeEdge(back, rim), BRepBuilderAPI_MakeEdge(rim, shoulder),
                                  BRepBuilderAPI_MakeEdge(GC_MakeArcOfEllipse(ellipse, 0, pi / 2, true).Value()),
                                  BRepBuilderAPI_MakeEdge(nose, back));
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(profile.Wire()), gp_Ax1(back, gp_Dir(1, 0, 0)));
}

TopoDS_Shape nacelle() {
  double half = nacelle_width / 2;
  TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(nacelle_front, -half, hub_height - half),
                                         gp_Pnt(nacelle_front + nacelle_length, half, hub_height + half));
  BRepFilletAPI_MakeFillet rounded(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
    rounded.Add(nacelle_rounding, TopoDS::Edge(edge.Current()));
  rounded.Build();
  return rounded.Shape();
}

}  // namespace

TopoDS_Shape wind_generator() {
  TopTools_ListOfShape body, rest;
  body.Append(BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), tower_foot, tower_top, tower_height));
  rest.Append(nacelle());
  gp_Pnt inside_spinner(spinner_back - 200, 0, hub_height);
  rest.Append(BRepPrimAPI_MakeCylinder(gp_Ax2(inside_spinner, gp_Dir(1, 0, 0)), shaft_radius, 600));
  rest.Append(spinner());
  TopoDS_Shape upright = blade();
  for (int i = 0; i < 3; ++i) {
    gp_Trsf place, turn;
    place.SetTranslation(gp_Vec(rotor_plane, 0, hub_height));
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, hub_height), gp_Dir(1, 0, 0)), 2 * pi * i / 3 + 0.35);
    rest.Append(BRepBuilderAPI_Transform(upright, turn * place));
  }
  BRepAlgoAPI_Fuse fuse;
  fuse.SetArguments(body);
  fuse.SetTools(rest);
  fuse.Build();
  TopExp_Explorer solid(fuse.Shape(), TopAbs_SOLID);
  if (fuse.HasErrors() || !solid.More()) throw Standard_Failure("the parts of the wind generator do not join");
  return solid.Current();
}
