// Wires and pipe bends, whose sides are far longer than the way round them.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Circ.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

struct Bend {
  double ring, tube, degrees, h, max_turn = 45;
};

std::ostream& operator<<(std::ostream& out, const Bend& bend) {
  return out << bend.ring << " " << bend.tube << " " << bend.degrees << " at " << bend.h << ", " << bend.max_turn;
}

class BentPipe : public testing::TestWithParam<Bend> {};

TEST_P(BentPipe, IsFollowedByItsElements) {
  const Bend& bend = GetParam();
  Options options;
  options.size = bend.h;
  options.max_turn = bend.max_turn * std::numbers::pi / 180;
  const TopoDS_Shape shape = BRepPrimAPI_MakeTorus(bend.ring, bend.tube, bend.degrees * std::numbers::pi / 180).Shape();
  const RunReport report = test::mesh_of(shape, options).report;
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.quality.triangles, 0);
  EXPECT_LT(report.quality.distance.angle, 5) << "middles beside the rows of their sides turn elements about the pipe";
  EXPECT_LT(report.quality.distance.largest, 0.02 * bend.tube);
  EXPECT_GT(report.quality.min_jacobian_ratio, 0.2);
  EXPECT_NEAR(report.quality.mesh_area, report.quality.cad_area, 0.005 * report.quality.cad_area);
}

INSTANTIATE_TEST_SUITE_P(Wires, BentPipe,
                         testing::Values(Bend{40, 2, 300, 29.691}, Bend{40, 1, 300, 19.315}, Bend{40, 2, 360, 29.691},
                                         Bend{40, 2, 300, 29.691, 30}, Bend{40, 2, 300, 29.691, 20}));
INSTANTIATE_TEST_SUITE_P(Elbows, BentPipe,
                         testing::Values(Bend{40, 6, 90, 1e6}, Bend{20, 6, 90, 1e6}, Bend{20, 6, 180, 40},
                                         Bend{12, 6, 90, 24}));

/// Through five points.
TopoDS_Shape winding_pipe(double radius) {
  TColgp_Array1OfPnt points(1, 5);
  const gp_Pnt places[] = {{0, 0, 0}, {20, 5, 3}, {40, -10, 8}, {60, 10, -5}, {80, 0, 0}};
  for (int i = 0; i < 5; ++i) points.SetValue(i + 1, places[i]);
  const Handle(Geom_BSplineCurve) curve = GeomAPI_PointsToBSpline(points).Curve();
  gp_Pnt start;
  gp_Vec along;
  curve->D1(curve->FirstParameter(), start, along);
  const TopoDS_Edge circle = BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(start, along), radius));
  const TopoDS_Edge line = BRepBuilderAPI_MakeEdge(curve);
  BRepOffsetAPI_MakePipeShell maker(BRepBuilderAPI_MakeWire(line).Wire());
  maker.SetMode(true);
  maker.Add(BRepBuilderAPI_MakeWire(circle).Wire());
  maker.Build();
  return maker.Shape();
}

// Lengths that count turns say little about elements so much longer than the pipe is wide.
TEST(BentPipes, AlongSplinesHaveRowsOfQuads) {
  for (double h : {30.0, 14.0, 6.0}) {
    const RunReport report = test::report_of(winding_pipe(2), h);
    EXPECT_STREQ(verdict(report), "sound") << h;
    EXPECT_EQ(report.quality.triangles, 0) << h;
    EXPECT_LT(report.quality.distance.angle, 6) << h;
  }
}

// What is laid at the poles, whose chords make sharp corners of them, met in the middle.
TEST(BentPipes, EndInHalfBallsBetweenTheirPoles) {
  TopoDS_Shape shape = BRepPrimAPI_MakeTorus(30, 3, std::numbers::pi).Shape();
  for (double x : {-30.0, 30.0})
    shape = BRepAlgoAPI_Fuse(shape, BRepPrimAPI_MakeSphere(gp_Pnt(x, 0, 0), 3).Shape()).Shape();
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  for (double h : {30.0, 9.0, 6.0, 4.0}) {
    const RunReport report = test::report_of(unify.Shape(), h);
    EXPECT_STREQ(verdict(report), "sound") << h;
    EXPECT_NEAR(report.quality.mesh_area, report.quality.cad_area, 0.002 * report.quality.cad_area) << h;
  }
}

}  // namespace
}  // namespace paver
