// Shapes with faults of all kinds are meshed as the clean ones, and the report says what was repaired.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>

#include "core/brep/shape_files.h"
#include "support/faulty_shapes.h"
#include "support/report_of.h"

namespace paver {
namespace {

constexpr double size = 6;

class Mend : public testing::TestWithParam<test::FaultyShape> {};

TEST_P(Mend, MakesItWhole) {
  const test::FaultyShape& faulty = GetParam();
  const RunReport report = test::report_of(faulty.shape(), size);
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_EQ(report.quality.nonmanifold_edges, 0);
  EXPECT_NEAR(report.quality.mesh_area, faulty.area(), 1e-3 * faulty.area());
  std::vector<std::string> kinds;
  for (const Repair& repair : report.model.repairs) {
    kinds.push_back(repair_name(repair.kind));
    EXPECT_GT(repair.count, 0);
    EXPECT_GE(repair.distance, 0);
  }
  EXPECT_EQ(kinds, faulty.repairs);
}

INSTANTIATE_TEST_SUITE_P(Faults, Mend, testing::ValuesIn(test::faulty_shapes()),
                         [](const auto& given) { return given.param.name; });

TEST(Mend, LeavesLoopsOpenThatMissAnEdge) {
  const RunReport report = test::report_of(test::without_an_edge(test::slotted_tube()), size);
  const auto failed = std::count_if(report.faces.begin(), report.faces.end(),
                                    [](const FaceReport& face) { return face.status == FaceStatus::failed; });
  EXPECT_EQ(failed, 1);
  EXPECT_TRUE(report.model.repairs.empty());
}

TEST(Mend, PutsImagesWhereTheVerticesAre) {
  const RunReport report = test::report_of(test::plate_with_corners_aside(0.7), 0.4);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_EQ(report.quality.inverted, 0);
  EXPECT_GT(report.quality.sj_all.min, 0);
  ASSERT_EQ(report.model.repairs.size(), 1u);
  EXPECT_EQ(report.model.repairs[0].kind, RepairKind::image);
  EXPECT_NEAR(report.model.repairs[0].distance, 0.7 * std::sqrt(2), 1e-6);
}

TEST(Mend, ConnectsWhatItHasMended) {
  const TopoDS_Shape ring = test::with_garbled_rings(test::frustum(), true);
  const TopoDS_Shape board = BRepPrimAPI_MakeBox(gp_Pnt(-30, -30, 10), 60, 60, 8).Shape();
  const RunReport report = test::report_of(test::compound({ring, board}), size);
  EXPECT_EQ(report.components.size(), 1u);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
}

TEST(Mend, KeepsFacesThatLieSideBySide) {
  // Both halves have the same border and area.
  const RunReport report = test::report_of(test::lens(), size);
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_TRUE(report.model.repairs.empty());
}

/// Straight edges between vertices of a list, in its order.
TopoDS_Wire wire_through(const std::vector<TopoDS_Vertex>& vertices) {
  TopoDS_Wire wire;
  BRep_Builder builder;
  builder.MakeWire(wire);
  for (std::size_t i = 0; i < vertices.size(); ++i)
    builder.Add(wire, BRepBuilderAPI_MakeEdge(vertices[i], vertices[(i + 1) % vertices.size()]).Edge());
  return wire;
}

TEST(Mend, AHoleThatRunsAlongASideIsAPieceOfTheBorder) {
  auto at = [](double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex(); };
  const TopoDS_Vertex low = at(10, 4), high = at(10, 6);
  for (bool is_turned : {false, true}) {
    TopoDS_Face face =
        BRepBuilderAPI_MakeFace(gp_Pln(), wire_through({at(0, 0), at(10, 0), low, high, at(10, 10), at(0, 10)}));
    const std::vector<TopoDS_Vertex> hole{high, low, at(7, 5)}, turned(hole.rbegin(), hole.rend());
    BRep_Builder().Add(face, wire_through(is_turned ? turned : hole));
    const RunReport report = test::report_of(face, 2);
    EXPECT_TRUE(faults(report).empty()) << faults(report).front();
    EXPECT_STREQ(verdict(report), "sound");
    EXPECT_NEAR(report.quality.mesh_area, 100 - 3, 1e-6);
  }
}

TEST(Mend, AHoleTouchesASideWithAVertexOfItsOwn) {
  auto at = [](double x, double y) { return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex(); };
  TopoDS_Face face =
      BRepBuilderAPI_MakeFace(gp_Pln(), wire_through({at(0, 0), at(10, 0), at(10, 5), at(10, 10), at(0, 10)}));
  BRep_Builder().Add(face, wire_through({at(10, 5), at(7, 3), at(7, 7)}));
  const RunReport report = test::report_of(face, 2);
  EXPECT_TRUE(faults(report).empty()) << faults(report).front();
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_NEAR(report.quality.mesh_area, 100 - 6, 1e-6);
}

}  // namespace
}  // namespace paver
