// Edges divided opposite the ends of others that run along them, and what the meshes of narrow gaps are worth for it.
#include "sizing/gaps/divide_at_gaps.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <gp_Ax3.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <vector>

#include "support/has_node.h"
#include "support/plates.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::has_node;
using test::plate;

/// What two coupled lines of 20 x 1.2 leave of a plate, one `off` farther along than the other, `gap` mm apart.
TopoDS_Shape beside_lines(double gap, double off) {
  TopoDS_Shape rest = BRepAlgoAPI_Cut(plate(-5, -12, 45, 12), plate(0, 0.5 * gap, 20, 0.5 * gap + 1.2)).Shape();
  return BRepAlgoAPI_Cut(rest, plate(off, -0.5 * gap - 1.2, off + 20, -0.5 * gap)).Shape();
}

/// Lengths of the edges of a model, rising.
std::vector<double> lengths(const TopoDS_Shape& shape, double h) {
  Model model = test::model_of(shape);
  Options options;
  options.size = h;
  divide_at_gaps(model, options);
  std::vector<double> lengths;
  for (const Edge& edge : model.edges) lengths.push_back(edge.length);
  std::ranges::sort(lengths);
  return lengths;
}

TEST(DivideAtGaps, WhereOtherEdgesBeginAndEnd) {
  const std::vector<double> found = lengths(beside_lines(0.1, 7), 2);
  const std::vector<double> expected{1.2, 1.2, 1.2, 1.2, 7, 7, 13, 13, 20, 20, 24, 24, 50, 50};
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
}

TEST(DivideAtGaps, NotAcrossWideOnesNorForShortPieces) {
  EXPECT_EQ(lengths(beside_lines(0.5, 7), 2).size(), 12U);
  EXPECT_EQ(lengths(beside_lines(0.1, 0.4), 2).size(), 12U);
  EXPECT_EQ(lengths(beside_lines(0.1, 0), 2).size(), 12U);
}

TEST(DivideAtGaps, ThenNodesFaceEachOther) {
  for (const double gap : {0.03, 0.2})
    for (const double off : {3.7, 9.1, 13.0})
      for (const double h : {3.5, 2.2, 1.4}) {
        const RunReport report = test::report_of(beside_lines(gap, off), h);
        EXPECT_GT(report.quality.sj_all.min, 0.15) << gap << " " << off << " " << h;
      }
}

// A slot that leaves two strips of a plate: of one loop two are left, odd or not.
TEST(DivideAtGaps, AlsoOnBothSidesOfASlot) {
  for (const double gap : {0.01, 0.1})
    for (const double h : {2.0, 1.3}) {
      const TopoDS_Shape frame = BRepAlgoAPI_Cut(plate(-7, -4, 7, 4), plate(-4.5, -4 + gap, 4.5, 4 - gap)).Shape();
      const RunReport report = test::report_of(frame, h);
      EXPECT_GT(report.quality.sj_all.min, 0.15) << gap << " " << h;
      EXPECT_LE(report.quality.triangles, 4) << gap << " " << h;
    }
}

// A fin stands on a strip, from one end of it to beyond a third.
TEST(DivideAtGaps, AlsoBesideALineInsideAFace) {
  const TopoDS_Shape fin =
      BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp::Origin(), gp::DY(), gp::DX())), 0, 11, -4, 0).Shape();
  const MeshResult result = test::mesh_of(test::compound({plate(0, -1, 30, 1), fin}), 10);
  EXPECT_EQ(result.report.quality.triangles, 0);
  for (double y : {-1.0, 0.0, 1.0}) EXPECT_TRUE(has_node(result.mesh, {11, y, 0})) << y;
}

// A line ends beside a round patch: its corner lies within 2e-5 to 1e-3 mm of the circle, which leaves it at once.
TEST(DivideAtGaps, AlsoWhereAGapWidensAtOnce) {
  for (const double off : {0.015, 0.05, 0.1})
    for (const double h : {3.5, 2.1, 1.06, 0.7}) {
      const TopoDS_Shape rest = BRepAlgoAPI_Cut(plate(-15, -15, 15, 15), test::disc(0, 0, 6)).Shape();
      const TopoDS_Shape board = BRepAlgoAPI_Cut(rest, plate(off, -15, off + 1, -6)).Shape();
      const RunReport report = test::report_of(board, h);
      EXPECT_STREQ(verdict(report), "sound") << off << " " << h;
      EXPECT_GT(report.quality.sj_all.min, 0.15) << off << " " << h;
    }
}

// Their vertices lie elsewhere: one more on each, where they are nearest.
TEST(DivideAtGaps, WhereTwoCirclesComeNearest) {
  const auto bored = [](double radius, double gap) {
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), 2);
    const TopoDS_Shape bore = BRepBuilderAPI_Transform(test::disc(0, 0, radius), turn).Shape();
    turn.SetTranslation({0, 3 - gap - radius, 0});
    return BRepAlgoAPI_Cut(test::disc(0, 0, 3), bore.Moved(TopLoc_Location(turn))).Shape();
  };
  for (const double radius : {2.0, 1.0, 0.5})
    for (const double gap : {1e-5, 1e-3, 0.005}) {
      for (const double h : {6.0, 1.0, 0.3}) {
        const MeshResult result = test::mesh_of(bored(radius, gap), h);
        EXPECT_STREQ(verdict(result.report), "sound") << radius << " " << gap << " " << h;
        EXPECT_LT(result.report.quality.quads + result.report.quality.triangles, 450);
        EXPECT_GT(result.report.quality.sj_all.min, 0.05) << radius << " " << gap << " " << h;
        EXPECT_TRUE(has_node(result.mesh, {0, 3, 0})) << radius << " " << gap << " " << h;
        EXPECT_TRUE(has_node(result.mesh, {0, 3 - gap, 0})) << radius << " " << gap << " " << h;
      }
    }
}

}  // namespace
}  // namespace paver
