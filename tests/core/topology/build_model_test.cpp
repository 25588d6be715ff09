// Shapes to models: loops, sharing, sewing, orientation, poles, repairs, report.
#include "topology/build_model.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <gp_Circ.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <numbers>

#include "core/brep/shape_files.h"
#include "support/alone.h"

namespace paver {
namespace {

using test::compound;
using test::loose_faces;
using test::model_of;

constexpr double pi = std::numbers::pi;

Vec2 uv_at(const Model& model, const Coedge& c, double share) {
  const Edge& edge = edge_of(model, c);
  double s = c.is_reversed ? 1 - share : share;
  return c.pcurve->uv(edge.t0 + s * (edge.t1 - edge.t0));
}

/// What every model must satisfy.
void expect_sound(const Model& model) {
  for (const Face& face : model.faces) {
    EXPECT_EQ(face.fault, "") << face.name;
    for (const Loop& loop : face.loops) {
      for (std::size_t i = 0; i < loop.coedges.size(); ++i) {
        const Coedge& a = loop.coedges[i];
        const Coedge& b = loop.coedges[(i + 1) % loop.coedges.size()];
        const Edge &ea = edge_of(model, a), &eb = edge_of(model, b);
        EXPECT_EQ(a.is_reversed ? ea.start : ea.end, b.is_reversed ? eb.end : eb.start) << face.name;
        EXPECT_LE(norm(uv_at(model, b, 0) - uv_at(model, a, 1)), 1e-6) << face.name;
        if (ea.is_degenerate) continue;
        for (int k = 0; k <= 8; ++k) {
          double t = ea.t0 + (ea.t1 - ea.t0) * k / 8;
          EXPECT_LE(norm(ea.curve->point(t) - face.surface->point(a.pcurve->uv(t))), 1e-6) << ea.name;
        }
      }
    }
  }
}

double loop_area(const Model& model, const Loop& loop) {
  std::vector<Vec2> points;
  for (const Coedge& c : loop.coedges)
    for (int i = 0; i < 32; ++i) points.push_back(uv_at(model, c, i / 32.0));
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) area += 0.5 * cross(points[i], points[(i + 1) % points.size()]);
  return area;
}

/// Share of faces whose outward normal at a point of the first edge looks away from `inside`.
void expect_outward(const Model& model, Vec3 inside) {
  for (const Face& face : model.faces) {
    const auto [x, xu, xv] = face.surface->slope(uv_at(model, face.loops[0].coedges[0], 0.3));
    Vec3 normal = (face.is_reversed ? -1.0 : 1.0) * cross(xu, xv);
    EXPECT_GE(dot(normal, x - inside), -1e-9) << face.name;
  }
}

TEST(BuildModel, ListsABoxAsItIs) {
  Model model = model_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  expect_sound(model);
  EXPECT_EQ(model.faces.size(), 6u);
  EXPECT_EQ(model.edges.size(), 12u);
  EXPECT_EQ(model.vertices.size(), 8u);
  EXPECT_EQ(model.faces[2].name, "Face3");
  EXPECT_EQ(model.edges[11].name, "Edge12");
  for (const Edge& edge : model.edges) EXPECT_EQ(edge.faces.size(), 2u);
  EXPECT_NEAR(model.report.area, 22, 1e-9);
  EXPECT_NEAR(model.report.diagonal, std::sqrt(14.0), 1e-9);
  EXPECT_EQ(model.report.solids, 1);
  EXPECT_EQ(model.report.shells, 1);
  EXPECT_EQ(model.report.free_edges, 0);
  EXPECT_EQ(model.report.sew_tolerance, 0);
  EXPECT_TRUE(model.notes.empty());
  expect_outward(model, {0.5, 1, 1.5});
}

TEST(BuildModel, KeepsTheFaceToTheLeftOfItsLoops) {
  TopoDS_Shape plate = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 1).Shape(),
                                       BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 5, -1), gp::DZ()), 2, 3).Shape());
  Model model = model_of(plate);
  expect_sound(model);
  int holed = 0;
  for (const Face& face : model.faces) {
    if (face.surface->kind() != SurfaceKind::plane) continue;
    double sum = 0;
    for (const Loop& loop : face.loops) sum += loop_area(model, loop);
    EXPECT_NEAR(sum, face.area, 0.1);
    if (face.loops.size() == 2) {
      ++holed;
      EXPECT_LT(std::min(loop_area(model, face.loops[0]), loop_area(model, face.loops[1])), 0);
    }
  }
  EXPECT_EQ(holed, 2);
}

TEST(BuildModel, TurnsLoopsThatRunTheWrongWay) {
  BRepBuilderAPI_MakeWire outer(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 5)).Edge());
  BRepBuilderAPI_MakeWire inner(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), 2)).Edge());
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Ax3()), 1e-7);
  builder.Add(face, outer.Wire().Reversed());
  builder.Add(face, inner.Wire());
  Model model = model_of(face);
  ASSERT_EQ(model.faces[0].loops.size(), 2u);
  EXPECT_NEAR(loop_area(model, model.faces[0].loops[0]), 25 * pi, 1);
  EXPECT_NEAR(loop_area(model, model.faces[0].loops[1]), -4 * pi, 1);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(model.notes[0].find("Face1"), std::string::npos);
}

TEST(BuildModel, MarksPolesAndPeriodicEdges) {
  Model sphere = model_of(BRepPrimAPI_MakeSphere(3).Shape());
  expect_sound(sphere);
  EXPECT_EQ(std::count_if(sphere.edges.begin(), sphere.edges.end(), [](const Edge& e) { return e.is_degenerate; }), 2);
  EXPECT_EQ(std::count_if(sphere.edges.begin(), sphere.edges.end(), [](const Edge& e) { return e.is_periodic; }), 1);
  EXPECT_EQ(sphere.faces[0].loops[0].coedges.size(), 4u);
  EXPECT_EQ(sphere.report.free_edges, 0);

  Model torus = model_of(BRepPrimAPI_MakeTorus(3, 1).Shape());
  expect_sound(torus);
  EXPECT_EQ(torus.edges.size(), 2u);
  EXPECT_TRUE(torus.edges[0].is_periodic && torus.edges[1].is_periodic);
  EXPECT_EQ(torus.edges[0].faces.size(), 2u);

  Model cone = model_of(BRepPrimAPI_MakeCone(2, 0, 3).Shape());
  expect_sound(cone);
  EXPECT_EQ(std::count_if(cone.edges.begin(), cone.edges.end(), [](const Edge& e) { return e.is_degenerate; }), 1);
}

TEST(BuildModel, GivesAFaceWithoutLoopsItsNaturalBounds) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_SphericalSurface(gp_Ax3(), 2), 1e-7);
  Model model = model_of(face);
  expect_sound(model);
  ASSERT_EQ(model.faces[0].loops.size(), 1u);
  EXPECT_NEAR(model.faces[0].area, 16 * pi, 1e-9);
  EXPECT_FALSE(TopExp_Explorer(face, TopAbs_WIRE).More()) << "the input stays as it was";

  TopoDS_Face endless;
  builder.MakeFace(endless, new Geom_Plane(gp_Ax3()), 1e-7);
  Model faulty = model_of(compound({endless, BRepPrimAPI_MakeBox(1, 1, 1).Shape()}));
  EXPECT_NE(faulty.faces[0].fault.find("infinite"), std::string::npos);
  EXPECT_EQ(faulty.faces[1].fault, "");
}

TEST(BuildModel, SewsLooseFacesAndTurnsThemOutwards) {
  std::vector<TopoDS_Shape> faces = loose_faces(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  for (std::size_t i = 1; i < faces.size(); i += 2) faces[i].Reverse();
  TopoDS_Compound loose = compound(faces);
  Model model = model_of(loose);
  expect_sound(model);
  EXPECT_EQ(model.edges.size(), 12u);
  EXPECT_EQ(model.vertices.size(), 8u);
  EXPECT_EQ(model.report.free_edges, 0);
  EXPECT_EQ(model.report.sewn_edges, 24);
  EXPECT_GT(model.report.sew_tolerance, 0);
  EXPECT_LE(model.report.sew_tolerance, 0.01);
  expect_outward(model, {0.5, 1, 1.5});
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(loose, TopAbs_EDGE, edges);
  EXPECT_EQ(edges.Extent(), 24) << "the input stays as it was";
}

TEST(BuildModel, DoesNotSewWhenToldSo) {
  Options options;
  options.sew_tolerance = 0;
  options.connect = Connect::none;
  Model model = model_of(compound(loose_faces(BRepPrimAPI_MakeBox(1, 2, 3).Shape())), options);
  EXPECT_EQ(model.report.free_edges, 24);
  EXPECT_EQ(model.report.free_edge_names.size(), 24u);
  EXPECT_EQ(model.report.sew_tolerance, 0);
}

TEST(BuildModel, ClosesAGapWithinTheToleranceOnly) {
  auto square = [](double x0, double z) {
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(x0, 0, z), gp::DZ()), 0, 1, 0, 1).Face();
  };
  TopoDS_Compound pair = compound({square(0, 0), square(1, 1e-3)});
  Options options;
  options.sew_tolerance = 2e-3;
  Model sewn = model_of(pair, options);
  EXPECT_EQ(sewn.report.sewn_edges, 2);
  EXPECT_EQ(sewn.edges.size(), 7u);
  options.sew_tolerance = 5e-4;
  Model open = model_of(pair, options);
  EXPECT_EQ(open.report.sewn_edges, 0);
  EXPECT_EQ(open.report.free_edges, 8);
}

// Annular slots and the feed of a dipole of two tubes are drawn so; the faces to both sides lie on one surface.
TEST(BuildModel, LeavesSlotsOfOneSurfaceOpen) {
  auto circle = [](double radius) {
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), radius))).Wire();
  };
  auto tube = [](double from, double to) {
    return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 2), 0, 2 * M_PI, from, to).Face();
  };
  BRepBuilderAPI_MakeFace plane(gp_Pln(), -50, 50, -40, 40);
  plane.Add(TopoDS::Wire(circle(10).Reversed()));
  for (const double width : {0.05, 0.2}) {
    const TopoDS_Face disc = BRepBuilderAPI_MakeFace(circle(10 - width)).Face();
    const Model ring = model_of(compound({plane.Face(), disc}), {});
    EXPECT_EQ(ring.report.sewn_edges, 0);
    EXPECT_EQ(ring.report.free_edges, 6);
    const Model dipole = model_of(compound({tube(-75, -0.5 * width), tube(0.5 * width, 75)}), {});
    EXPECT_EQ(dipole.report.sewn_edges, 0);
    EXPECT_EQ(dipole.report.free_edges, 4);
  }
}

/// A block with a narrow bevel, in loose faces; one of them ends in an arc that bulges away from its neighbour.
TopoDS_Compound block_with_a_crack(double bulge, double bevel) {
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {bevel, 1, 0}, {0, 1 - bevel, 0}};
  auto raised = [](gp_Pnt p) { return gp_Pnt(p.X(), p.Y(), 1); };
  auto face_of = [](const std::vector<gp_Pnt>& points) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& point : points) polygon.Add(point);
    polygon.Close();
    return BRepBuilderAPI_MakeFace(polygon.Wire(), true).Face();
  };
  std::vector<gp_Pnt> top;
  for (gp_Pnt p : corners) top.push_back(raised(p));
  std::vector<TopoDS_Shape> faces{face_of(corners), face_of(top)};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const gp_Pnt a = corners[i], b = corners[(i + 1) % corners.size()];
    faces.push_back(face_of({a, b, raised(b), raised(a)}));
  }
  const gp_Pnt a = corners[0], b = corners[1];
  BRepBuilderAPI_MakeWire front(
      BRepBuilderAPI_MakeEdge(a, b),
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, gp_Pnt(1 - bulge, 0, 0.5), raised(b)).Value()),
      BRepBuilderAPI_MakeEdge(raised(b), raised(a)), BRepBuilderAPI_MakeEdge(raised(a), a));
  faces.push_back(BRepBuilderAPI_MakeFace(front.Wire(), true).Face());
  return compound(faces);
}

TEST(BuildModel, ClosesACrackThoughAnEdgeElsewhereIsShorter) {
  Model model = model_of(block_with_a_crack(4e-4, 1e-3));
  EXPECT_EQ(model.report.free_edges, 0);
  EXPECT_EQ(model.edges.size(), 15u);
  EXPECT_GT(model.report.sew_tolerance, 4e-4);
  EXPECT_LT(model.report.sew_tolerance, 1e-3);
}

TEST(BuildModel, LeavesACrackAsWideAsTheEdgesAtIt) {
  EXPECT_EQ(model_of(block_with_a_crack(0.1, 1e-3)).report.free_edges, 2);
}

TEST(BuildModel, LeavesTouchingSolidsApartWhenToldSo) {
  TopoDS_Compound pair =
      compound({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Shape()});
  Options options;
  options.connect = Connect::none;
  Model model = model_of(pair, options);
  EXPECT_EQ(model.faces.size(), 12u);
  EXPECT_EQ(model.edges.size(), 24u);
  EXPECT_EQ(model.report.solids, 2);
  EXPECT_EQ(model.report.nonmanifold_edges, 0);
}

TEST(BuildModel, KeepsSharingOfMoreThanTwoFaces) {
  TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(0, 0, 1));
  auto fin = [&](gp_Pnt a, gp_Pnt b) {
    TopoDS_Vertex first = TopExp::FirstVertex(edge), last = TopExp::LastVertex(edge);
    TopoDS_Edge top = BRepBuilderAPI_MakeEdge(BRep_Tool::Pnt(last), b), side = BRepBuilderAPI_MakeEdge(b, a),
                bottom = BRepBuilderAPI_MakeEdge(a, BRep_Tool::Pnt(first));
    BRepBuilderAPI_MakeWire wire(edge, top, side, bottom);
    return BRepBuilderAPI_MakeFace(wire.Wire(), true).Face();
  };
  Model model = model_of(compound({fin(gp_Pnt(1, 0, 0), gp_Pnt(1, 0, 1)), fin(gp_Pnt(-1, 1, 0), gp_Pnt(-1, 1, 1)),
                                   fin(gp_Pnt(-1, -1, 0), gp_Pnt(-1, -1, 1))}));
  EXPECT_EQ(model.report.nonmanifold_edges, 1);
  ASSERT_EQ(model.report.nonmanifold_edge_names.size(), 1u);
  EXPECT_EQ(model.report.free_edges, 9);
  EXPECT_EQ(model.report.sewn_edges, 0);
}

TEST(BuildModel, TurnsAnInsideOutSolid) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  Model model = model_of(box.Reversed());
  expect_outward(model, {0.5, 0.5, 0.5});
  EXPECT_EQ(model.notes.size(), 1u);
}

TEST(BuildModel, LeavesTheShellOfACavityLookingInwards) {
  TopoDS_Shape hollow =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 5), 2).Shape());
  Model model = model_of(hollow);
  EXPECT_TRUE(model.notes.empty());
  for (const Face& face : model.faces) {
    if (face.surface->kind() != SurfaceKind::sphere) continue;
    const auto [x, xu, xv] = face.surface->slope({1, 0.2});
    double side = dot(cross(xu, xv), x - Vec3{5, 5, 5});
    EXPECT_TRUE(face.is_reversed == (side > 0));
  }
}

TEST(BuildModel, DropsFacesWithoutArea) {
  TopoDS_Face sliver = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(5, 0, 0), gp::DZ()), 0, 1, 0, 1e-12).Face();
  Model model = model_of(compound({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), sliver}));
  ASSERT_EQ(model.faces.size(), 7u);
  EXPECT_FALSE(model.faces[6].has_area);
  EXPECT_TRUE(model.faces[6].loops.empty());
  EXPECT_EQ(model.edges.size(), 12u);
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(model.notes[0].find("Face7"), std::string::npos);
}

TEST(BuildModel, MakesAMissingImageOnAFace) {
  TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(1, 2).Shape();
  TopoDS_Face side = TopoDS::Face(TopExp_Explorer(cylinder, TopAbs_FACE).Current());
  for (TopExp_Explorer edges(side, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (!BRep_Tool::IsClosed(edge, side)) BRep_Builder().UpdateEdge(edge, Handle(Geom2d_Curve)(), side, 1e-7);
  }
  Model model = model_of(cylinder);
  expect_sound(model);
  for (const Face& face : model.faces) EXPECT_TRUE(face.has_area) << face.name;
  double first = 0, last = 0;
  int missing = 0;
  for (TopExp_Explorer edges(side, TopAbs_EDGE); edges.More(); edges.Next())
    missing += BRep_Tool::CurveOnSurface(TopoDS::Edge(edges.Current()), side, first, last).IsNull();
  EXPECT_GT(missing, 0) << "the input stays as it was";
}

TEST(BuildModel, TurnsTinyEdgesIntoPoints) {
  gp_Pnt a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(1e-9, 1, 0), e(0, 1, 0);
  TopoDS_Vertex v[5];
  BRep_Builder builder;
  gp_Pnt points[] = {a, b, c, d, e};
  for (int i = 0; i < 5; ++i) builder.MakeVertex(v[i], points[i], 1e-12);
  TopoDS_Wire whole;
  TopoDS_Face face;
  builder.MakeWire(whole);
  for (int i = 0; i < 5; ++i) {
    TopoDS_Edge edge;
    gp_Vec along(points[i], points[(i + 1) % 5]);
    builder.MakeEdge(edge, new Geom_Line(points[i], gp_Dir(along)), 1e-12);
    builder.Add(edge, v[i].Oriented(TopAbs_FORWARD));
    builder.Add(edge, v[(i + 1) % 5].Oriented(TopAbs_REVERSED));
    builder.Range(edge, 0, along.Magnitude());
    builder.Add(whole, edge);
  }
  builder.MakeFace(face, new Geom_Plane(gp_Ax3()), 1e-7);
  builder.Add(face, whole);
  Model model = model_of(face);
  EXPECT_EQ(model.vertices.size(), 4u);
  EXPECT_EQ(std::count_if(model.edges.begin(), model.edges.end(), [](const Edge& x) { return x.is_degenerate; }), 1);
  EXPECT_EQ(model.report.free_edges, 4);
  ASSERT_EQ(model.faces[0].loops.size(), 1u);
  EXPECT_EQ(model.faces[0].loops[0].coedges.size(), 5u);
}

TEST(BuildModel, FaultsAFaceWithAnOpenBoundary) {
  BRepBuilderAPI_MakeWire open(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)),
                               BRepBuilderAPI_MakeEdge(gp_Pnt(1, 0, 0), gp_Pnt(1, 1, 0)));
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, new Geom_Plane(gp_Ax3()), 1e-7);
  builder.Add(face, open.Wire());
  Model model = model_of(compound({BRepPrimAPI_MakeBox(1, 1, 1).Shape(), face}));
  const Face& broken = model.faces[6];
  EXPECT_TRUE(!broken.has_area || broken.fault.find("open") != std::string::npos) << broken.fault;
  EXPECT_TRUE(broken.loops.empty());
  EXPECT_EQ(model.faces[0].fault, "");
}

// The kernel cannot cut such edges where those of other faces end, which is how faces are sewn.
TEST(BuildModel, DoesNotFailForEdgesThatLackAnEnd) {
  auto rectangle = [](double x0, double x1, double y0, double y1) {
    return BRepBuilderAPI_MakeFace(gp_Pln(), x0, x1, y0, y1).Shape();
  };
  for (int broken = 0; broken < 4; ++broken) {
    SCOPED_TRACE(broken);
    const TopoDS_Shape face = rectangle(0, 2, 0, 1);
    TopExp_Explorer edges(face, TopAbs_EDGE);
    for (int i = 0; i < broken; ++i) edges.Next();
    TopoDS_Edge edge = TopoDS::Edge(edges.Current());
    edge.Free(true);
    BRep_Builder().Remove(edge, TopExp::LastVertex(edge));
    const Model model = model_of(compound({face, rectangle(0, 1, -1, 0), rectangle(1, 2, -1, 0)}));
    ASSERT_EQ(model.faces.size(), 3u);
    EXPECT_EQ(model.faces[1].fault, "");
    EXPECT_EQ(model.faces[2].fault, "");
  }
}

TEST(BuildModel, IsTheSameEveryTime) {
  TopoDS_Compound loose = compound(loose_faces(BRepPrimAPI_MakeCylinder(1, 2).Shape()));
  Model a = model_of(loose), b = model_of(loose);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].name, b.edges[i].name);
    EXPECT_EQ(a.edges[i].start, b.edges[i].start);
    EXPECT_EQ(a.edges[i].length, b.edges[i].length);
  }
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) EXPECT_EQ(a.vertices[i], b.vertices[i]);
}

TEST(BuildModel, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  Shape box = test::as_shape(BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  test::Alone alone(progress);
  EXPECT_THROW(build_model(box, {}, {}, progress, alone), Error);
}

}  // namespace
}  // namespace paver
