// Parts that touch along faces that are written differently: one exact, one an approximation or turned by rounding.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::mesh_of;

constexpr double radius = 5, height = 10;

TopoDS_Shape block() {
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), 20, 20, height).Shape(),
                         BRepPrimAPI_MakeCylinder(radius, height).Shape())
      .Shape();
}

/// Its outline is a spline through so many points of the circle.
TopoDS_Shape spline_plug(int points) {
  Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, points);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    places->SetValue(i + 1, gp_Pnt(radius * std::cos(angle), radius * std::sin(angle), 0));
  }
  GeomAPI_Interpolate outline(places, true, 1e-9);
  outline.Perform();
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(outline.Curve());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(edge).Wire(), true);
  return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
}

double largest_face_contact(const ModelReport& report) {
  double largest = 0;
  for (const Contact& contact : report.contacts)
    if (contact.kind == ContactKind::face) largest = std::max(largest, contact.size);
  return largest;
}

bool tells_of_merging(const RunReport& report) {
  return std::ranges::any_of(
      report.notes, [](const std::string& note) { return note.find("written differently") != std::string::npos; });
}

TEST(ConnectApproximated, ASplinePlugFillsItsHole) {
  for (int points : {8, 24}) {
    const MeshResult result = mesh_of(compound({block(), spline_plug(points)}), 3);
    EXPECT_TRUE(faults(result.report).empty() && doubts(result.report).empty()) << points;
    EXPECT_NEAR(largest_face_contact(result.report.model), 2 * std::numbers::pi * radius * height, 3) << points;
    EXPECT_NEAR(result.report.quality.mesh_area, 8 * 20 * 10 / 2 + 2 * 400 + 2 * std::numbers::pi * radius * height,
                20);
    EXPECT_GT(result.report.quality.sj_all.min, 0.4);
    EXPECT_TRUE(tells_of_merging(result.report));
  }
}

TEST(ConnectApproximated, ALidTurnedByRoundingLiesOnItsBox) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(3, 2, 10), gp_Dir(1, 0.4, 0)), 7e-4);
  const TopoDS_Shape lid =
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 10), 20, 15, 5).Shape(), turn, true).Shape();
  const MeshResult result = mesh_of(compound({BRepPrimAPI_MakeBox(20, 15, 10).Shape(), lid}), 4);
  EXPECT_TRUE(faults(result.report).empty() && doubts(result.report).empty());
  EXPECT_NEAR(largest_face_contact(result.report.model), 300, 1);
  EXPECT_GT(result.report.quality.sj_all.min, 0.5);
}

TEST(ConnectApproximated, AWedgeOfADegreeStaysOne) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 10), gp_Dir(0, -1, 0)), 1 * std::numbers::pi / 180);
  const TopoDS_Shape lid =
      BRepBuilderAPI_Transform(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 10), 20, 15, 5).Shape(), turn, true).Shape();
  const MeshResult result = mesh_of(compound({BRepPrimAPI_MakeBox(20, 15, 10).Shape(), lid}), 4);
  EXPECT_EQ(largest_face_contact(result.report.model), 0);
  EXPECT_FALSE(tells_of_merging(result.report));
}

// Moved by 4e-7 of the diagonal, some parts run into each other, others have a gap.
TEST(ConnectApproximated, PartsMovedByRoundingAreConnected) {
  constexpr double off = 1e-5;
  const TopoDS_Shape floor = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -2), 30, 20, 2 + off).Shape(),
                     wall = BRepPrimAPI_MakeBox(gp_Pnt(10 + off, -10, 0), 10, 20, height).Shape(),
                     plug = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(off, 0, 0), gp::DZ()), radius, height).Shape();
  const RunReport report = test::report_of(compound({block(), plug, floor, wall}), 3);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.components.size(), 1U);
  EXPECT_TRUE(tells_of_merging(report));
  const double area = (2 * 30 + 2 * 20) * 12 + 3 * 600 + 20 * height + 2 * std::numbers::pi * radius * height;
  EXPECT_NEAR(report.quality.mesh_area, area, 1e-3 * area);
}

// The strip that both tops have is as thin.
TEST(ConnectApproximated, PartsThatOverlapByRoundingShareAFace) {
  const double off = 1e-4;
  const TopoDS_Shape wall = BRepPrimAPI_MakeBox(gp_Pnt(10 - off, -10, 0), 5, 20, height).Shape(),
                     plug = BRepPrimAPI_MakeCylinder(radius + off, height).Shape();
  for (const TopoDS_Shape& other : {wall, plug}) {
    const RunReport report = test::report_of(compound({block(), other}), 3);
    EXPECT_STREQ(verdict(report), "sound");
    EXPECT_TRUE(tells_of_merging(report));
    EXPECT_GT(largest_face_contact(report.model), 199);
  }
}

// A tolerance that closes the plug's misfit of 0.06 mm would connect the wall, which is drawn 0.02 mm away.
TEST(ConnectApproximated, NothingThatIsApartIsConnected) {
  const TopoDS_Shape floor = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, -2), 30, 20, 2).Shape(),
                     wall = BRepPrimAPI_MakeBox(gp_Pnt(10.02, -10, 0), 5, 20, height).Shape();
  const ModelReport report = mesh_of(compound({block(), spline_plug(8), floor, wall}), 3).report.model;
  for (const Contact& contact : report.contacts)
    EXPECT_FALSE(contact.parts[0] == "Solid1" && contact.parts[1] == "Solid4");
  EXPECT_FALSE(report.unconnected.empty());
}

}  // namespace
}  // namespace paver
