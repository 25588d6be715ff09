// A face is left out for want of area only where its border runs back along itself; else it is named as faulty.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

TopoDS_Face flat_face(const TopoDS_Wire& wire) {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face, new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1))), 1e-7);
  BRep_Builder().Add(face, wire);
  return face;
}

/// A face beside a box of 10.
MeshResult with_box(const TopoDS_Face& face) {
  return test::mesh_of(test::compound({BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 0), 10, 10, 10).Shape(), face}), 3);
}

void expect_left_out(const TopoDS_Face& face) {
  const MeshResult result = with_box(face);
  EXPECT_EQ(result.report.faces[6].status, FaceStatus::no_area) << result.report.faces[6].reason;
  EXPECT_FALSE(shortfall(result));
  EXPECT_STREQ(verdict(result.report), "sound");
}

void expect_faulty(const TopoDS_Face& face, const std::string& reason) {
  const MeshResult result = with_box(face);
  EXPECT_EQ(result.report.faces[6].status, FaceStatus::failed);
  EXPECT_EQ(result.report.faces[6].reason.find(reason), 0u) << result.report.faces[6].reason;
  ASSERT_TRUE(shortfall(result));
  EXPECT_EQ(shortfall(result)->code(), ErrorCode::face_failed);
  EXPECT_STREQ(verdict(result.report), "faulty");
}

TopoDS_Wire polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon maker;
  for (const gp_Pnt& point : points) maker.Add(point);
  maker.Close();
  return maker.Wire();
}

TEST(LostAreas, LeaveOutASliverBetweenTwoArcs) {
  // One arc twice, there as a circle and back as a spline, whose pieces end elsewhere.
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), 8);
  const Handle(Geom_TrimmedCurve) arc = new Geom_TrimmedCurve(circle, 0.3, 2.5);
  const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(arc);
  const double middle = 0.6 * spline->FirstParameter() + 0.4 * spline->LastParameter();
  const TopoDS_Edge there = BRepBuilderAPI_MakeEdge(arc),
                    first = BRepBuilderAPI_MakeEdge(spline, spline->FirstParameter(), middle),
                    second = BRepBuilderAPI_MakeEdge(spline, middle, spline->LastParameter());
  BRepBuilderAPI_MakeWire wire(there);
  wire.Add(TopoDS::Edge(first.Reversed()));
  wire.Add(TopoDS::Edge(second.Reversed()));
  ASSERT_TRUE(wire.IsDone());
  expect_left_out(flat_face(wire.Wire()));
}

TEST(LostAreas, LeaveOutWhatIsNarrowOrTiny) {
  expect_left_out(flat_face(polygon({{0, 0, 5}, {8, 0, 5}, {8, 1e-9, 5}, {0, 1e-9, 5}})));
  expect_left_out(flat_face(polygon({{0, 0, 5}, {8, 1e-9, 5}, {8, 0, 5}})));
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), 2e-5));
  expect_left_out(flat_face(BRepBuilderAPI_MakeWire(circle)));
}

TEST(LostAreas, NameABorderWhoseAreasCancel) {
  expect_faulty(flat_face(polygon({{0, 0, 5}, {8, 8, 5}, {8, 0, 5}, {0, 8, 5}})),
                "its boundary encloses something where its surface has no area at Edge");
}

TEST(LostAreas, NameABorderThatIsOpen) {
  expect_faulty(flat_face(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 5), gp_Pnt(8, 0, 5)).Edge())),
                "its boundary is open at Edge13");
}

/// On a sphere of radius 5, with a loop that runs up along a line between two latitudes and back.
TopoDS_Face about_meridian(double from, double to) {
  const Handle(Geom_Surface) sphere = new Geom_SphericalSurface(gp_Ax3(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)), 5);
  TopoDS_Face face;
  TopoDS_Wire wire;
  BRep_Builder builder;
  builder.MakeFace(face, sphere, 1e-7);
  builder.MakeWire(wire);
  const TopoDS_Edge up = BRepBuilderAPI_MakeEdge(new Geom2d_Line(gp_Pnt2d(1, 0), gp_Dir2d(0, 1)), sphere, from, to);
  const TopoDS_Edge down = BRepBuilderAPI_MakeEdge(new Geom2d_Line(gp_Pnt2d(1, 0), gp_Dir2d(0, -1)), sphere,
                                                   TopExp::LastVertex(up), TopExp::FirstVertex(up), -to, -from);
  for (const TopoDS_Edge& edge : {up, down}) BRepLib::BuildCurve3d(edge), builder.Add(wire, edge);
  builder.Add(face, wire);
  return face;
}

// The inner skin of a ball with a void, as STEP has what IGES had: the kernel finds no area.
TEST(LostAreas, ASphereWhoseLoopRunsFromPoleToPoleAndBackIsWhole) {
  const double pi = std::numbers::pi;
  const MeshResult result = with_box(about_meridian(-pi / 2, pi / 2));
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_NEAR(result.report.faces[6].mesh_area, 100 * pi, 0.5);
  EXPECT_EQ(result.report.quality.border_edges, 0);
}

TEST(LostAreas, NameWhatIsLeftOfAFaceThatWentRound) {
  expect_faulty(about_meridian(-1, 0.5), "its boundary is a line from which its surface goes round at Edge");
}

// A nick in a corner: its faces are small, but no slivers, and the box is open without them.
TEST(LostAreas, AreToldWhereTheyLeaveAHole) {
  for (double nick : {1e-3, 1e-4, 2e-5}) {
    const TopoDS_Shape corner = BRepPrimAPI_MakeBox(nick, nick, nick);
    const RunReport report = test::report_of(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 10, 10), corner), 2);
    EXPECT_EQ(report.model.holes.size(), report.quality.border_edges > 0 ? 3u : 0u) << nick;
    EXPECT_STREQ(verdict(report), report.quality.border_edges > 0 ? "doubtful" : "sound") << nick;
  }
}

}  // namespace
}  // namespace paver
