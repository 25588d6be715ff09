// Tips where several faces meet, or one that goes round by more than half a turn.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <cmath>
#include <gp.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

/// The wall of a cone with a slant of 60, in equal pieces. The profile, and so the pieces' parameters, starts or ends
/// at the apex.
TopoDS_Shape wall(double half_angle, int pieces, bool ends_at_apex) {
  const gp_Pnt apex(0, 0, 60 * std::cos(half_angle)), rim(60 * std::sin(half_angle), 0, 0);
  BRepBuilderAPI_Sewing sewing;
  for (int i = 0; i < pieces; ++i) {
    gp_Trsf turn;
    turn.SetRotation(gp::OZ(), 2 * pi * i / pieces);
    const TopoDS_Edge profile =
        ends_at_apex ? BRepBuilderAPI_MakeEdge(rim, apex).Edge() : BRepBuilderAPI_MakeEdge(apex, rim).Edge();
    sewing.Add(BRepPrimAPI_MakeRevol(profile, gp::OZ(), 2 * pi / pieces).Shape().Moved(turn));
  }
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(TipsInPieces, ColumnsEndInAFaceThatGoesNearlyRound) {
  for (double degrees : {240.0, 300.0, 340.0}) {
    const TopoDS_Shape cut = BRepPrimAPI_MakeCone(15, 0, 60, degrees * pi / 180).Shape();
    for (double h : {1.5, 4.0}) {
      const RunReport report = test::report_of(cut, h);
      EXPECT_LT(test::longest_side(report), 1.7 * h) << degrees << " " << h;
      EXPECT_LT(report.quality.distance.largest, 0.02 * h) << degrees << " " << h;
    }
  }
}

TEST(TipsInPieces, AreNearTheSurfaceWhereverTheParametersStart) {
  for (bool ends_at_apex : {false, true})
    for (int pieces : {2, 3, 4})
      for (double half_angle : {25.0, 33.0, 38.0}) {
        const double h = 3;
        const RunReport report = test::report_of(wall(half_angle * pi / 180, pieces, ends_at_apex), h);
        EXPECT_LT(report.quality.distance.largest, 0.025 * h) << pieces << " " << half_angle << " " << ends_at_apex;
      }
}

TEST(TipsInPieces, ColumnsStayInTheMiddleOfFineMeshes) {
  for (double h : {0.55, 0.6, 0.7})
    EXPECT_GT(test::report_of(wall(20 * pi / 180, 4, false), h).quality.min_jacobian_ratio, 0.25) << h;
}

}  // namespace
}  // namespace paver
