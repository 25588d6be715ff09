// Faces with creases inside: pieces, sharing with neighbours, names; smooth knots stay.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::mesh_of;
using test::model_of;

/// A polygon in x and z, pulled along y from `y` by 2: degree 1 in u with knots 0, 1, 2 and so on at its corners.
Handle(Geom_BSplineSurface) pulled(const std::vector<gp_Pnt>& polygon, double y = 0) {
  int n = static_cast<int>(polygon.size());
  TColgp_Array2OfPnt poles(1, n, 1, 2);
  TColStd_Array1OfReal u_knots(1, n), v_knots(1, 2);
  TColStd_Array1OfInteger u_counts(1, n), v_counts(1, 2);
  for (int i = 1; i <= n; ++i) {
    const gp_Pnt& p = polygon[static_cast<std::size_t>(i - 1)];
    poles(i, 1) = gp_Pnt(p.X(), y, p.Z());
    poles(i, 2) = gp_Pnt(p.X(), y + 2, p.Z());
    u_knots(i) = i - 1;
    u_counts(i) = i == 1 || i == n ? 2 : 1;
  }
  v_knots(1) = 0, v_knots(2) = 1;
  v_counts(1) = v_counts(2) = 2;
  return new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, 1, 1);
}

TopoDS_Face face_of(const Handle(Geom_BSplineSurface) & surface) {
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

long crease_count(const Model& model) {
  return std::count_if(model.edges.begin(), model.edges.end(),
                       [](const Edge& edge) { return edge.name.rfind("Added", 0) == 0; });
}

long shared_count(const Model& model) {
  return std::count_if(model.edges.begin(), model.edges.end(), [](const Edge& edge) { return edge.faces.size() == 2; });
}

/// Loops close in space and (u, v), images lie on their curves, no edge is periodic.
void expect_pieces(const Model& model) {
  for (const Face& face : model.faces) {
    ASSERT_EQ(face.fault, "");
    for (const Loop& loop : face.loops) {
      for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
        const Coedge &a = loop.coedges[i], &b = loop.coedges[(i + 1) % loop.coedges.size()];
        const Edge &ea = model.edges[static_cast<std::size_t>(a.edge)],
                   &eb = model.edges[static_cast<std::size_t>(b.edge)];
        EXPECT_EQ(a.is_reversed ? ea.start : ea.end, b.is_reversed ? eb.end : eb.start);
        EXPECT_LE(norm(a.pcurve->uv(a.is_reversed ? ea.t0 : ea.t1) - b.pcurve->uv(b.is_reversed ? eb.t1 : eb.t0)),
                  1e-9);
        double middle = 0.5 * (ea.t0 + ea.t1);
        if (ea.is_degenerate) continue;
        EXPECT_LE(norm(ea.curve->point(middle) - face.surface->point(a.pcurve->uv(middle))), 1e-9) << ea.name;
      }
    }
  }
  for (const Edge& edge : model.edges) EXPECT_FALSE(edge.is_periodic) << edge.name;
}

const std::vector<gp_Pnt> roof{{0, 0, 0}, {1, 0, 1}, {2, 0, 0}};
const std::vector<gp_Pnt> wedge{{0, 0, 0}, {3, 0, 1}, {4, 0, 0}, {3, 0, -1}, {0, 0, 0}};

TEST(DivideCreases, MakesACreaseAnEdge) {
  Model model = model_of(face_of(pulled(roof)));
  ASSERT_EQ(model.faces.size(), 2u);
  expect_pieces(model);
  EXPECT_EQ(model.report.faces, 1);
  for (const Face& face : model.faces) {
    EXPECT_EQ(face.name, "Face1");
    EXPECT_EQ(face.origin, 0);
    EXPECT_NEAR(face.area, 2 * std::sqrt(2.0), 1e-9);
  }
  EXPECT_EQ(crease_count(model), 1);
  EXPECT_EQ(shared_count(model), 1);
  EXPECT_EQ(model.edges.size(), 7u);
  std::set<std::string> names;
  for (const Edge& edge : model.edges) names.insert(edge.name);
  EXPECT_EQ(names, (std::set<std::string>{"Added1", "Edge1", "Edge2", "Edge3", "Edge4"}));
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(model.notes[0], "Face1 was divided along 1 crease.");
}

TEST(DivideCreases, AThinRoundedStripBetweenCreasesStaysWhole) {
  std::vector<gp_Pnt> polygon{{0, 0, 0}, {9, 0, 0}};  // out, 45 degrees, ten small turns, 45 degrees, and back
  for (int i = 0; i < 10; ++i) {
    const double way = (45 + 10 * i) * M_PI / 180;
    polygon.push_back(polygon.back().Translated(0.002 * gp_Vec(std::cos(way), 0, std::sin(way))));
  }
  polygon.emplace_back(0, 0, polygon.back().Z());
  Options options;
  options.size = 1e6;
  const Model model = model_of(face_of(pulled(polygon)), options);
  EXPECT_EQ(model.faces.size(), 3u);
  expect_pieces(model);
}

TEST(DivideCreases, LeavesSmoothKnotsAlone) {
  Model model = model_of(face_of(pulled({{0, 0, 0}, {1, 0, 0.1}, {2, 0, 0}})));
  EXPECT_EQ(model.faces.size(), 1u);
  EXPECT_EQ(crease_count(model), 0);
  EXPECT_TRUE(model.notes.empty());
}

TEST(DivideCreases, KeepsOriginsOfOtherFaces) {
  Model model = model_of(compound({face_of(pulled(roof)), BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 1, 1, 1).Shape()}));
  ASSERT_EQ(model.faces.size(), 8u);
  EXPECT_EQ(model.report.faces, 7);
  EXPECT_EQ(model.faces[2].name, "Face2");
  EXPECT_EQ(model.faces[7].origin, 6);
}

TEST(DivideCreases, DividesAClosedFaceWithCreasesInsideAndAtItsEnds) {
  Model model = model_of(face_of(pulled(wedge)));
  ASSERT_EQ(model.faces.size(), 4u);
  expect_pieces(model);
  EXPECT_EQ(shared_count(model), 4);
}

TEST(DivideCreases, DividesAFaceWhoseOnlyCreaseIsItsPeriodicEdge) {
  // A drop: smooth all around but for its tip, where it begins and ends.
  TColgp_Array2OfPnt poles(1, 5, 1, 2);
  const double x[] = {0, 3, 4, 3, 0}, z[] = {0, 1, 0, -1, 0};
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 2; ++j) poles(i, j) = gp_Pnt(x[i - 1], 2 * (j - 1), z[i - 1]);
  TColStd_Array1OfReal knots(1, 2);
  TColStd_Array1OfInteger u_counts(1, 2), v_counts(1, 2);
  knots(1) = 0, knots(2) = 1;
  u_counts.Init(5), v_counts.Init(2);
  Model model = model_of(face_of(new Geom_BSplineSurface(poles, knots, knots, u_counts, v_counts, 4, 1)));
  ASSERT_EQ(model.faces.size(), 2u);
  expect_pieces(model);
  EXPECT_EQ(shared_count(model), 2);
  EXPECT_EQ(crease_count(model), 1);
}

TEST(DivideCreases, LeavesOutStripsPressedFlat) {
  std::vector<gp_Pnt> pressed = wedge;
  pressed.insert(pressed.begin(), wedge.front());
  pressed.push_back(wedge.back());
  Model model = model_of(face_of(pulled(pressed)));
  ASSERT_EQ(model.faces.size(), 4u);
  expect_pieces(model);
  EXPECT_EQ(shared_count(model), 4);
}

TEST(DivideCreases, DividesCommonEdgesOnce) {
  // Two roofs in a row and a third one against them, sewn first; the last runs the other way.
  std::vector<gp_Pnt> back(roof.rbegin(), roof.rend());
  Model model = model_of(compound({face_of(pulled(roof)), face_of(pulled(roof, 2)), face_of(pulled(back, 4))}));
  ASSERT_EQ(model.faces.size(), 6u);
  expect_pieces(model);
  EXPECT_EQ(model.report.faces, 3);
  EXPECT_EQ(crease_count(model), 3);
  EXPECT_EQ(shared_count(model), 3 + 2 * 2);
}

// A wall across the ridge: both parts of the roof are on one surface, and each is divided.
TEST(DivideCreases, DividesPartsOfAFaceThatIsCrossed) {
  const TopoDS_Face wall = BRepBuilderAPI_MakeFace(gp_Pln({0, 1, 0}, {0, 1, 0}), -5, 5, -5, 5).Face();
  Model model = model_of(compound({face_of(pulled(roof)), wall}));
  std::map<std::string, std::vector<double>> areas;
  for (const Face& face : model.faces) {
    EXPECT_EQ(face.fault, "") << face.name;
    areas[face.name].push_back(face.area);
    for (const Coedge& use : coedges_of(face.loops)) EXPECT_TRUE(use.pcurve) << face.name;
  }
  ASSERT_EQ(areas["Face1"].size(), 4u);
  for (double area : areas["Face1"]) EXPECT_NEAR(area, std::sqrt(2.0), 1e-6);
}

/// On both sides of where the roof has its crease.
bool is_flat(const Surface& surface) { return dot(surface.normal({0.5, 0.1}), surface.normal({1.5, 0.1})) > 0.999; }

TEST(DivideCreases, DividesAFaceWithAHoleOnItsCrease) {
  const double radius = 0.3;
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({1, 1, -1}, {0, 0, 1}), radius, 4);
  Model model = model_of(BRepAlgoAPI_Cut(face_of(pulled(roof)), drill));
  ASSERT_EQ(model.faces.size(), 2u);
  for (const Face& face : model.faces) {
    EXPECT_EQ(face.fault, "");
    EXPECT_NEAR(face.area, std::sqrt(2.0) * (2 - 0.5 * M_PI * radius * radius), 1e-5);
    ASSERT_EQ(face.loops.size(), 1u) << "the hole is part of the border";
    EXPECT_TRUE(is_flat(*face.surface));
  }
}

/// A roof without the quarter beyond u = `along` and v = 0.5; the vertex in the notch lies `off` its place.
TopoDS_Face notched_roof(double along, double off) {
  const Handle(Geom_Surface) surface = pulled(roof);
  const std::vector<gp_Pnt2d> corners{{0, 0}, {2, 0}, {2, 0.5}, {along, 0.5}, {along, 1}, {0, 1}};
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const gp_Vec2d way(corners[i], corners[(i + 1) % corners.size()]);
    wire.Add(BRepBuilderAPI_MakeEdge(new Geom2d_Line(corners[i], way), surface, 0, way.Magnitude()).Edge());
  }
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire()).Face();
  BRepLib::BuildCurves3d(face);
  const gp_Pnt notch = surface->Value(along, 0.5);
  for (TopExp_Explorer vertices(face, TopAbs_VERTEX); vertices.More(); vertices.Next()) {
    const TopoDS_Vertex& vertex = TopoDS::Vertex(vertices.Current());
    if (off > 0 && BRep_Tool::Pnt(vertex).Distance(notch) < 1e-6)
      BRep_Builder().UpdateVertex(vertex, notch.Translated({0, off, 0}), 2 * off);
  }
  return face;
}

TEST(DivideCreases, CreasesThatGoOnAlongTheBorderEndWhereTheyMeetIt) {
  for (const auto& [along, off] : {std::pair{1.0, 0.0}, {1 + 1e-8, 0.0}, {1 - 1e-8, 0.0}, {1 - 1e-8, 1e-4}}) {
    SCOPED_TRACE(testing::Message() << along - 1 << " beside, vertex off by " << off);
    const Model model = model_of(notched_roof(along, off));
    ASSERT_EQ(model.faces.size(), 2u);
    EXPECT_NEAR(std::max(model.faces[0].area, model.faces[1].area), 2 * std::sqrt(2.0), 1e-3);
    EXPECT_NEAR(std::min(model.faces[0].area, model.faces[1].area), std::sqrt(2.0), 1e-3);
    EXPECT_EQ(crease_count(model), 1);
    EXPECT_EQ(model.edges.size(), 8u);
  }
}

TEST(DivideCreases, SurfacesOfPiecesOfASweptFaceWithAHoleEndAtTheCrease) {
  const TopoDS_Edge polygon = BRepBuilderAPI_MakeEdge(pulled(roof)->VIso(0)).Edge();
  const TopoDS_Shape swept = BRepPrimAPI_MakePrism(polygon, gp_Vec(0, 2, 0)).Shape();
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({1, 1, -1}, {0, 0, 1}), 0.3, 4);
  const Model model = model_of(BRepAlgoAPI_Cut(swept, drill).Shape());
  ASSERT_EQ(model.faces.size(), 2u);
  for (const Face& face : model.faces) EXPECT_TRUE(is_flat(*face.surface));
}

TEST(DivideCreases, NeighboursWithoutCreasesTakeOverDividedEdges) {
  // A flat gable end under the roof, in one triangle.
  Handle(Geom_BSplineSurface) gable = pulled({{0, 0, 0}, {1, 0, 1}, {2, 0, 0}});
  TColgp_Array2OfPnt poles(1, 3, 1, 2);
  for (int i = 1; i <= 3; ++i) {
    poles(i, 1) = gp_Pnt(i - 1, 0, i == 2 ? 1 : 0);
    poles(i, 2) = gp_Pnt(i - 1, 0, -1);
  }
  TColStd_Array1OfReal u_knots(1, 3), v_knots(1, 2);
  TColStd_Array1OfInteger u_counts(1, 3), v_counts(1, 2);
  u_knots(1) = 0, u_knots(2) = 1, u_knots(3) = 2;
  v_knots(1) = 0, v_knots(2) = 1;
  u_counts.Init(2), v_counts.Init(2);
  u_counts(2) = 1;
  TopoDS_Face flat = face_of(new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, 1, 1));
  Model model = model_of(compound({face_of(gable), flat}));
  ASSERT_EQ(model.faces.size(), 3u);
  EXPECT_EQ(crease_count(model), 1);
  EXPECT_EQ(shared_count(model), 1 + 2);
  EXPECT_EQ(model.faces[2].loops[0].coedges.size(), 5u);
  expect_pieces(model);
}

// The kernel would cut them at every period on the way.
// Creases are edges before parts are connected: no slit, point or end of a wire lies across one, or is lost with it.
TEST(DivideCreases, WhatEndsInsideAFaceIsConnected) {
  auto wire = [](gp_Pnt a, gp_Pnt b) { return BRepBuilderAPI_MakeEdge(a, b).Shape(); };
  const TopoDS_Shape skin = face_of(pulled(roof)), fin = BRepPrimAPI_MakeBox(gp_Pnt(0.6, 0.9, 0), 0.8, 0.2, 3).Shape();
  const std::map<const char*, TopoDS_Shape> others{
      {"wire", wire({0.4, 1, 0.4}, {0.4, 1, 2})},
      {"wire to the crease", wire({1, 1, 1}, {1, 1, 3})},
      {"wire along the crease", wire({1, 0.5, 1}, {1, 1.5, 1})},
      {"point", BRepBuilderAPI_MakeVertex(gp_Pnt(1.7, 0.6, 0.3)).Shape()},
      {"sheet across the crease",
       BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(1, 1, 1), gp::DY()), -1, 0.5, -0.5, 0.5).Shape()},
      {"post through the crease", fin}};
  for (const auto& [name, other] : others) {
    SCOPED_TRACE(name);
    const MeshResult result = mesh_of(compound({skin, other}), 0.5);
    EXPECT_EQ(result.report.components.size(), 1u);
    EXPECT_STREQ(verdict(result.report), "sound");
    EXPECT_TRUE(result.report.model.unconnected.empty());
  }
}

TEST(DivideCreases, WhatTwoCreasedFacesHaveInCommonIsOneEntry) {
  const TopoDS_Shape house = face_of(pulled({{0, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 0, -1}}));
  const RunReport report = test::report_of(compound({face_of(pulled(roof)), house}), 0.5);
  ASSERT_EQ(report.faces.size(), 3u);
  EXPECT_EQ(report.faces[0].status, FaceStatus::common);
  EXPECT_EQ(report.faces[1].status, FaceStatus::meshed);
  EXPECT_NEAR(report.faces[1].mesh_area, 2, 1e-9);
  EXPECT_EQ(report.faces[2].name, "Face1 + Face2");
  EXPECT_NEAR(report.faces[2].mesh_area, 4 * std::sqrt(2.0), 1e-9);
}

// A section that is one closed spline with a sharp end: the ring's surface is no spline, and closed both ways.
TEST(DivideCreases, DividesARingWithOneSharpEdge) {
  TColgp_Array1OfPnt poles(1, 5);
  const gp_Pnt at[] = {{50, 0, 0}, {40, 0, 8}, {20, 0, 6}, {20, 0, -6}, {50, 0, 0}};
  for (int i = 0; i < 5; ++i) poles(i + 1) = at[i];
  const TopoDS_Edge section = BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(new Geom_BezierCurve(poles)));
  const RunReport report = test::report_of(BRepPrimAPI_MakeRevol(section, gp::OZ()).Shape(), 8);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.quality.triangles, 0);
  EXPECT_GT(report.quality.sj_all.min, 0.6);
}

/// From a point to a section with a sharp edge where it closes.
TopoDS_Shape pointed_fin() {
  const Handle(TColgp_HArray1OfPnt) section = new TColgp_HArray1OfPnt(1, 7);
  const std::vector<gp_Pnt2d> half{{-12, 0}, {-4, 4}, {6, 3.5}, {11, 0}};
  for (int i = 0; i < 7; ++i) {
    const gp_Pnt2d& at = half[static_cast<std::size_t>(i < 4 ? i : 6 - i)];
    section->SetValue(i + 1, {80, at.X(), i < 4 ? at.Y() : -at.Y()});
  }
  GeomAPI_Interpolate through(section, false, 1e-6);
  through.Perform();
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(through.Curve()));
  BRepOffsetAPI_ThruSections loft(true, true);
  loft.AddVertex(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)));
  loft.AddWire(wire);
  return loft.Shape();
}

// At its point the line where it is divided ends in an edge without length.
TEST(DivideCreases, DividesAFaceThatComesToAPointAndHasAHole) {
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2({50, 1, -20}, gp::DZ()), 2, 40).Shape();
  const TopoDS_Shape fin = BRepAlgoAPI_Cut(pointed_fin(), hole).Shape();
  const Model model = model_of(fin);
  EXPECT_EQ(model.faces.size(), static_cast<std::size_t>(model.report.faces) + 1);
  for (const double size : {1e6, 20.0, 5.0}) {
    const RunReport report = test::report_of(fin, size);
    EXPECT_STREQ(verdict(report), "sound") << size;
    EXPECT_GT(report.quality.sj_all.min, 0.1) << size;
  }
}

TEST(DivideCreases, ImagesFarAwayAreLeftAlone) {
  const TopoDS_Face torus = TopoDS::Face(TopExp_Explorer(BRepPrimAPI_MakeTorus(3, 1).Shape(), TopAbs_FACE).Current());
  for (TopExp_Explorer edges(torus, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    TopLoc_Location location;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(torus, location);
    double t0 = 0, t1 = 0;
    const Handle(Geom2d_Curve) image = BRep_Tool::CurveOnSurface(edge, torus, t0, t1);
    if (std::abs(image->Value(t1).X() - image->Value(t0).X()) < 1) continue;
    const Handle(Geom2d_Curve) far = new Geom2d_Line({1e20, 2 * M_PI}, {1, 0});
    BRep_Builder().UpdateEdge(edge, new Geom2d_Line({0, 0}, {1, 0}), far, surface, location, 1e-7);
  }
  EXPECT_EQ(crease_count(model_of(torus)), 0);
}

}  // namespace
}  // namespace paver
