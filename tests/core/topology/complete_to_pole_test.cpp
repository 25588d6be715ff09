// Faces with nothing but a rim that goes once round: completed to the pole on the side where they lie, or named as
// faulty.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAPI_PointsToBSpline.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Ax1.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "support/folders.h"
#include "support/report_of.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 10, size = 2.5;

using SurfaceHandle = Handle(Geom_Surface);

/// A whole circle about a point `aside` of the z axis, revolved about it: poles inside its range in v, at the angles
/// where the circle meets the axis.
SurfaceHandle revolved_circle(double aside) {
  const gp_Ax2 plane(gp_Pnt(aside, 0, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0));
  return new Geom_SurfaceOfRevolution(new Geom_Circle(plane, radius), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
}

/// The same of a spline that starts at an angle and is closed without being periodic.
SurfaceHandle revolved_spline(double start) {
  const gp_Ax2 plane(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0), gp_Dir(std::cos(start), 0, std::sin(start)));
  const Handle(Geom_TrimmedCurve) circle = new Geom_TrimmedCurve(new Geom_Circle(plane, radius), 0, 2 * pi);
  const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(circle);
  spline->SetNotPeriodic();
  return new Geom_SurfaceOfRevolution(spline, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
}

SurfaceHandle ball() { return new Geom_SphericalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), radius); }

/// Rows at its ends that are points; `is_periodic`: else only closed.
SurfaceHandle spline_ball(bool is_periodic, bool is_round_u) {
  const Handle(Geom_BSplineSurface) spline =
      GeomConvert::SurfaceToBSplineSurface(new Geom_RectangularTrimmedSurface(ball(), 0, 2 * pi, -pi / 2, pi / 2));
  if (is_periodic) {
    spline->SetUPeriodic();
  } else {
    spline->SetUNotPeriodic();
  }
  if (!is_round_u) spline->ExchangeUV();
  return SurfaceHandle(spline);
}

SurfaceHandle cone() { return new Geom_ConicalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), -pi / 6, radius); }

/// A face's one loop, along the iso-line `at`.
struct Rim {
  SurfaceHandle surface;
  bool is_round_u = true;
  double at = 0;
  double start = 0;  ///< where round its first edge starts
  int edges = 1;
  bool is_against = false;   ///< walked against the parameter
  bool is_reversed = false;  ///< the face
  double aside = 0;          ///< of the second edge's image
  bool is_closed = false;    ///< by an edge back along all of it, put in first, as readers do
  bool is_turned = false;    ///< a reader has turned the loop afterwards
};

gp_Pnt2d uv_of(const Rim& rim, double round) {
  return rim.is_round_u ? gp_Pnt2d(round, rim.at) : gp_Pnt2d(rim.at, round);
}

double period_of(const Rim& rim) {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  rim.surface->Bounds(u0, u1, v0, v1);
  return rim.is_round_u ? u1 - u0 : v1 - v0;
}

TopoDS_Edge rim_edge(const Rim& rim, const TopoDS_Face& face, gp_Pnt2d origin) {
  TopoDS_Edge edge;
  BRep_Builder().MakeEdge(edge, rim.is_round_u ? rim.surface->VIso(rim.at) : rim.surface->UIso(rim.at), 1e-7);
  const Handle(Geom2d_Line) image = new Geom2d_Line(origin, rim.is_round_u ? gp_Dir2d(1, 0) : gp_Dir2d(0, 1));
  BRep_Builder().UpdateEdge(edge, image, face, 1e-7);
  return edge;
}

void end_edge(TopoDS_Edge edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
  BRep_Builder().Add(edge, first.Oriented(TopAbs_FORWARD));
  BRep_Builder().Add(edge, last.Oriented(TopAbs_REVERSED));
}

TopoDS_Wire rim_wire(const Rim& rim, TopoDS_Face& face) {
  const double step = period_of(rim) / rim.edges;
  BRep_Builder builder;
  std::vector<TopoDS_Vertex> vertices(static_cast<std::size_t>(rim.edges));
  for (int i = 0; i < rim.edges; ++i) {
    const gp_Pnt2d uv = uv_of(rim, rim.start + i * step);
    builder.MakeVertex(vertices[static_cast<std::size_t>(i)], rim.surface->Value(uv.X(), uv.Y()), 1e-7);
  }
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  const TopAbs_Orientation way = rim.is_against != rim.is_turned ? TopAbs_REVERSED : TopAbs_FORWARD;
  std::vector<TopoDS_Edge> edges;
  if (rim.is_closed) {
    edges.push_back(rim_edge(rim, face, uv_of(rim, 0)));
    end_edge(edges.back(), vertices[0], vertices[0]);
    builder.Range(edges.back(), rim.start, rim.start + rim.edges * step);
    edges.back().Orientation(TopAbs::Reverse(way));
  }
  for (int i = 0; i < rim.edges; ++i) {
    edges.push_back(rim_edge(rim, face, uv_of(rim, i == 1 ? rim.aside : 0)));
    end_edge(edges.back(), vertices[static_cast<std::size_t>(i)],
             vertices[static_cast<std::size_t>((i + 1) % rim.edges)]);
    builder.Range(edges.back(), rim.start + i * step, rim.start + (i + 1) * step);
    edges.back().Orientation(way);
  }
  if (rim.is_turned) std::reverse(edges.begin(), edges.end());
  for (const TopoDS_Edge& edge : edges) builder.Add(wire, edge);
  wire.Closed(true);
  return wire;
}

/// The face with nothing but its rim, and a flat lid on it.
TopoDS_Shape with_lid(const Rim& rim) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, rim.surface, 1e-7);
  TopoDS_Wire wire = rim_wire(rim, face);
  builder.Add(face, wire);
  if (rim.is_closed) {  // the lid's is another, as in files whose faces share nothing
    Rim plain = rim;
    plain.is_closed = plain.is_turned = false;
    TopoDS_Face other = face;
    wire = rim_wire(plain, other);
  }
  TopoDS_Compound whole;
  builder.MakeCompound(whole);
  builder.Add(whole, rim.is_reversed ? face.Reversed() : face);
  builder.Add(whole, BRepBuilderAPI_MakeFace(
                         gp_Pln(rim.surface->Value(uv_of(rim, 0).X(), uv_of(rim, 0).Y()), gp_Dir(0, 0, 1)), wire, true)
                         .Shape());
  return whole;
}

struct Case {
  std::string name;
  Rim rim;
  double area = 0;
  friend void PrintTo(const Case& given, std::ostream* out) { *out << given.name; }
};

double cap_area(double height) { return 2 * pi * radius * height; }

class CompleteToPole : public testing::TestWithParam<Case> {};

TEST_P(CompleteToPole, MakesItWhole) {
  const RunReport report = test::report_of(with_lid(GetParam().rim), size);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_TRUE(report.quality.watertight);
  // The kernel integrates across knots of periodic splines.
  EXPECT_NEAR(report.faces[0].cad_area, GetParam().area, 5e-3 * GetParam().area);
  EXPECT_NEAR(report.faces[0].mesh_area, GetParam().area, 1e-2 * GetParam().area);
  std::vector<RepairKind> kinds;
  for (const Repair& repair : report.model.repairs) kinds.push_back(repair.kind);
  std::erase_if(kinds,
                [](RepairKind kind) { return kind == RepairKind::turned_face || kind == RepairKind::sewn_edge; });
  EXPECT_EQ(kinds, (std::vector{RepairKind::periodic_edge, RepairKind::pole}));
}

std::vector<Case> cases() {
  const double low = -pi / 6, rest = cap_area(1.5 * radius), cap = cap_area(0.5 * radius);
  const double north = pi / 6;
  std::vector<Case> list{
      {"Revolution", {revolved_circle(0), true, north}, cap},
      {"RevolutionOtherSide", {.surface = revolved_circle(0), .at = north, .is_against = true}, rest},
      {"RevolutionReversed", {.surface = revolved_circle(0), .at = low, .is_reversed = true}, rest},
      {"RevolutionStartElsewhere", {.surface = revolved_circle(0), .at = north, .start = 1.1}, cap},
      {"RevolutionThreeEdges", {.surface = revolved_circle(0), .at = north, .edges = 3}, cap},
      {"RevolutionImagesAside", {.surface = revolved_circle(0), .at = north, .edges = 3, .aside = 2 * pi}, cap},
      {"Ball", {.surface = ball(), .at = north}, cap},
      {"BallOtherSide", {.surface = ball(), .at = north, .is_against = true}, rest},
      {"BallReversed", {.surface = ball(), .at = low, .is_reversed = true}, rest},
      {"Cone", {.surface = cone()}, 2 * pi * radius * radius},
      // Closed at the rim, and no more: the loop is a period off.
      {"SplineMeridian", {.surface = revolved_spline(north), .at = 0}, cap},
      {"SplineMeridianOtherEnd", {.surface = revolved_spline(north), .at = 2 * pi}, cap},
      {"SplineMeridianOtherSide", {.surface = revolved_spline(north), .at = 0, .is_against = true}, rest},
  };
  for (bool is_against : {false, true})
    for (bool is_turned : {false, true})
      for (int edges : {1, 3}) {
        const std::string name = std::string("Closed") + (is_turned ? "AndTurned" : "") +
                                 (is_against ? "Against" : "Along") + std::to_string(edges);
        list.push_back({name,
                        {.surface = revolved_circle(0),
                         .at = north,
                         .edges = edges,
                         .is_against = is_against,
                         .is_closed = true,
                         .is_turned = is_turned},
                        is_against ? rest : cap});
      }
  for (bool is_periodic : {true, false})
    for (bool is_round_u : {true, false})
      for (bool is_against : {true, false}) {
        const std::string name = std::string(is_periodic ? "Periodic" : "Closed") + (is_round_u ? "RoundU" : "RoundV") +
                                 (is_against ? "Against" : "Along");
        list.push_back(
            {name,
             {.surface = spline_ball(is_periodic, is_round_u), .is_round_u = is_round_u, .is_against = is_against},
             cap_area(radius)});
      }
  return list;
}

INSTANTIATE_TEST_SUITE_P(Rims, CompleteToPole, testing::ValuesIn(cases()),
                         [](const auto& given) { return given.param.name; });

TEST(CompleteToPole, TakesThePoleOnTheSideOfTheFace) {
  // A circle through the axis twice: inside these two it is a lemon, outside an apple.
  const double aside = 4, corner = std::acos(-aside / radius);
  auto area_of = [&](double from, double to) {  // of revolution, between two angles
    return 2 * pi * radius * std::abs(aside * (to - from) + radius * (std::sin(to) - std::sin(from)));
  };
  for (bool is_against : {false, true}) {
    const RunReport apple =
        test::report_of(with_lid({.surface = revolved_circle(aside), .at = 0.5, .is_against = is_against}), size);
    EXPECT_TRUE(apple.quality.watertight);
    EXPECT_NEAR(apple.faces[0].cad_area, area_of(0.5, is_against ? -corner : corner), 0.1);
    const RunReport lemon =
        test::report_of(with_lid({.surface = revolved_circle(aside), .at = pi + 0.3, .is_against = is_against}), size);
    EXPECT_TRUE(lemon.quality.watertight);
    EXPECT_NEAR(lemon.faces[0].cad_area, area_of(pi + 0.3, is_against ? corner : 2 * pi - corner), 0.1);
  }
}

/// An edge by its image alone, along `image`.
TopoDS_Edge edge_along(const Handle(Geom2d_Curve) & image, const TopoDS_Face& face) {
  BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge);
  builder.UpdateEdge(edge, image, face, 1e-7);
  builder.Range(edge, image->FirstParameter(), image->LastParameter());
  BRepLib::BuildCurve3d(edge);
  TopoDS_Vertex vertex;
  builder.MakeVertex(vertex, BRepAdaptor_Curve(edge).Value(image->FirstParameter()), 1e-6);
  builder.Add(edge, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(edge, vertex.Oriented(TopAbs_REVERSED));
  return edge;
}

TopoDS_Wire wire_along(const Handle(Geom2d_Curve) & image, const TopoDS_Face& face) {
  TopoDS_Wire wire;
  BRep_Builder().MakeWire(wire);
  BRep_Builder().Add(wire, edge_along(image, face));
  wire.Closed(true);
  return wire;
}

/// Once round the surface, up and down around `at`.
Handle(Geom2d_Curve) wave(double at, double height) {
  constexpr int count = 65;
  TColgp_Array1OfPnt2d points(1, count);
  for (int i = 0; i < count; ++i) {
    const double u = 2 * pi * i / (count - 1);
    points(i + 1) = {u, at + height * std::sin(3 * u)};
  }
  return Handle(Geom2d_Curve)(Geom2dAPI_PointsToBSpline(points, 3, 8, GeomAbs_C2, 1e-6).Curve());
}

TopoDS_Face with_loops(const SurfaceHandle& surface, const std::vector<Handle(Geom2d_Curve)>& images) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, surface, 1e-7);
  for (const Handle(Geom2d_Curve) & image : images) BRep_Builder().Add(face, wire_along(image, face));
  return face;
}

Handle(Geom2d_Curve) hole(double u, double v) {
  const Handle(Geom2d_Circle) circle =
      new Geom2d_Circle(gp_Circ2d(gp_Ax2d(gp_Pnt2d(u, v), gp_Dir2d(1, 0)), 0.3, false));
  return new Geom2d_TrimmedCurve(circle, 0, 2 * pi);
}

TEST(CompleteToPole, IsSewnToANeighbourWithARimOfItsOwn) {
  TopoDS_Compound loose;
  BRep_Builder().MakeCompound(loose);
  const TopoDS_Shape whole = with_lid({.surface = revolved_circle(0), .at = -pi / 6});
  for (TopoDS_Iterator faces(whole); faces.More(); faces.Next())
    BRep_Builder().Add(loose, BRepBuilderAPI_Copy(faces.Value()).Shape());
  const RunReport report = test::report_of(loose, size);
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  // What was added counts.
  EXPECT_NEAR(report.model.diagonal, std::hypot(2 * radius, 2 * radius, 1.5 * radius), 1e-6);
}

TEST(CompleteToPole, KeepsThePlacement) {
  gp_Trsf turn, move;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.7);
  move.SetTranslation(gp_Vec(100, -20, 7));
  const TopoDS_Shape moved =
      with_lid({.surface = revolved_circle(0), .at = pi / 6}).Moved(TopLoc_Location(move * turn));
  const RunReport report = test::report_of(moved, size);
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_NEAR(report.faces[0].cad_area, cap_area(0.5 * radius), 0.1);
}

TEST(CompleteToPole, MakesMissingImagesFirst) {
  for (const SurfaceHandle& surface : {revolved_circle(0), ball(), spline_ball(true, true)}) {
    const TopoDS_Shape whole = with_lid({.surface = surface});
    TopoDS_Iterator faces(whole);
    const TopoDS_Face face = TopoDS::Face(faces.Value());
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      BRep_Builder().UpdateEdge(TopoDS::Edge(edges.Current()), Handle(Geom2d_Curve)(), face, 1e-7);
    const RunReport report = test::report_of(whole, size);
    EXPECT_TRUE(report.quality.watertight);
    EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  }
}

TEST(CompleteToPole, MakesWrongImagesAnewFirst) {
  for (const SurfaceHandle& surface : {revolved_circle(0), ball()}) {
    const TopoDS_Shape whole = with_lid({.surface = surface, .at = pi / 6});
    TopoDS_Iterator faces(whole);
    const TopoDS_Face face = TopoDS::Face(faces.Value());
    for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
      BRep_Builder().UpdateEdge(TopoDS::Edge(edges.Current()), new Geom2d_Line(gp_Pnt2d(0.7, 1.2), gp_Dir2d(1, 0)),
                                face, 1e-7);
    const RunReport report = test::report_of(whole, size);
    EXPECT_TRUE(report.quality.watertight);
    EXPECT_TRUE(faults(report).empty()) << faults(report).front();
    EXPECT_NEAR(report.faces[0].cad_area, cap_area(0.5 * radius), 1);
  }
}

TEST(CompleteToPole, TakesTheSideOfAWavyRim) {
  const double whole = cap_area(0.5 * radius);
  for (const SurfaceHandle& surface : {revolved_circle(0), ball()}) {
    const RunReport report = test::report_of(with_loops(surface, {wave(pi / 6, 0.2)}), size);
    EXPECT_TRUE(faults(report).empty()) << faults(report).front();
    EXPECT_NEAR(report.quality.mesh_area, whole, 0.02 * whole);
  }
}

TEST(CompleteToPole, KeepsHoles) {
  auto area = [](const SurfaceHandle& surface, double u) {
    const RunReport report = test::report_of(with_loops(surface, {wave(pi / 6, 0), hole(u, 1)}), size);
    EXPECT_TRUE(faults(report).empty()) << faults(report).front();
    return report.quality.mesh_area;
  };
  const double whole = cap_area(0.5 * radius), holed = whole - pi * 3 * 3 * std::cos(1.0);
  EXPECT_NEAR(area(revolved_circle(0), 3), holed, 0.02 * whole);
  EXPECT_NEAR(area(ball(), 3), holed, 0.02 * whole);
  // Between the rim's only vertex and the pole.
  EXPECT_NEAR(area(ball(), 0.2), holed, 0.02 * whole);
}

TEST(CompleteToPole, AddsThePoleToAPeriodicEdge) {
  // Rim, periodic edge up, periodic edge down.
  const SurfaceHandle surface = revolved_circle(0);
  TopoDS_Face face;
  BRep_Builder builder;
  builder.MakeFace(face, surface, 1e-7);
  const Rim rim{.surface = surface, .at = pi / 6};
  TopoDS_Wire wire = rim_wire(rim, face);
  TopoDS_Vertex top;
  builder.MakeVertex(top, gp_Pnt(0, 0, radius), 1e-7);
  TopoDS_Edge side;
  builder.MakeEdge(side, surface->UIso(0), 1e-7);
  builder.UpdateEdge(side, new Geom2d_Line(gp_Pnt2d(2 * pi, 0), gp_Dir2d(0, 1)),
                     new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(0, 1)), face, 1e-7);
  builder.Add(side, TopoDS::Vertex(TopExp_Explorer(wire, TopAbs_VERTEX).Current()).Oriented(TopAbs_FORWARD));
  builder.Add(side, top.Oriented(TopAbs_REVERSED));
  builder.Range(side, pi / 6, pi / 2);
  builder.Add(wire, side.Oriented(TopAbs_FORWARD));
  builder.Add(wire, side.Oriented(TopAbs_REVERSED));
  builder.Add(face, wire);
  const RunReport report = test::report_of(face, size);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_NEAR(report.quality.mesh_area, cap_area(0.5 * radius), 1);
  ASSERT_EQ(report.model.repairs.size(), 1u);
  EXPECT_EQ(report.model.repairs[0].kind, RepairKind::pole);
  EXPECT_EQ(report.model.edges, 3);
}

TEST(CompleteToPole, NamesAFaceWithoutAPole) {
  const SurfaceHandle tube = new Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), radius);
  for (const SurfaceHandle& surface : {tube, revolved_circle(3 * radius)}) {
    const MeshResult result = test::mesh_of(with_lid({.surface = surface, .at = 0.2}), size);
    const FaceReport& face = result.report.faces[0];
    EXPECT_EQ(face.status, FaceStatus::failed);
    EXPECT_NE(face.reason.find("goes once round and nothing ends it on the other side at Edge1"), std::string::npos)
        << face.reason;
    EXPECT_EQ(result.report.faces[1].status, FaceStatus::meshed);
    EXPECT_STREQ(verdict(result.report), "faulty");
    ASSERT_TRUE(shortfall(result));
    EXPECT_EQ(shortfall(result)->code(), ErrorCode::face_failed);
  }
}

TEST(CompleteToPole, KeepsTheCapOfAConeSphere) {
  const std::filesystem::path path = test::shared_folder() / "tips" / "conesphere_2faces.step";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "needs a real model, " << path << " is missing: set PAVER_SHARED";
  Options options;
  options.size = 20;
  Progress progress;
  const RunReport report = mesh_file(path, options, progress).report;
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  for (const FaceReport& face : report.faces) EXPECT_EQ(face.status, FaceStatus::meshed) << face.name;
}

}  // namespace
}  // namespace paver
