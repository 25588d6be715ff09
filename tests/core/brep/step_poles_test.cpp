// Balls with rods and holes where their periodic edge is, written to STEP and read again.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopoDS_Shell.hxx>
#include <cmath>

#include "brep/occt_impl.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::area_of;

std::shared_ptr<Shape> read_again(const TopoDS_Shape& shape) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("model.step");
  test::write_step(shape, path);
  ModelReport report;
  Progress progress;
  return read_shape(path, report, progress);
}

TopoDS_Shape ball() { return BRepPrimAPI_MakeSphere(50).Shape(); }
TopoDS_Shape rod(gp_Dir along, double radius = 8) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 0}, along), radius, 100).Shape();
}

/// Versions of the kernel lose more or fewer. It finds areas of splines to a hundredth only.
void expect_whole(const TopoDS_Shape& shape, std::size_t most_restored, double accuracy = 1e-4) {
  const std::shared_ptr<Shape> read = read_again(shape);
  EXPECT_NEAR(area_of(read->shape), area_of(shape), accuracy * area_of(shape));
  EXPECT_LE(read->restored.size(), most_restored);
  Progress progress;
  test::Alone alone(progress);
  Options options;
  options.size = 1;
  const Model model = build_model(*read, options, {}, progress, alone);
  double area = 0;
  for (const Face& face : model.faces) {
    area += face.area;
    EXPECT_EQ(face.fault, "");
  }
  EXPECT_NEAR(area, area_of(shape), accuracy * area_of(shape));
}

TEST(StepPoles, OfABallWithARodAlongItsXAxisAreNotLost) {
  expect_whole(BRepAlgoAPI_Fuse(ball(), rod({1, 0, 0})).Shape(), 1);
}

TEST(StepPoles, NorWhereAHoleLiesAskewOverThePeriodicEdge) {
  expect_whole(BRepAlgoAPI_Cut(ball(), rod({1, 0.1, 0.5})).Shape(), 1);
  expect_whole(BRepAlgoAPI_Cut(ball(), BRepPrimAPI_MakeBox(gp_Pnt{30, -10, -12}, 40, 30, 20).Shape()).Shape(), 1);
}

TEST(StepPoles, NorWhereTwoHolesDo) {
  const TopoDS_Shape one = BRepAlgoAPI_Fuse(ball(), rod({1, 0, 1})).Shape();
  expect_whole(BRepAlgoAPI_Fuse(one, rod({1, 0, -1})).Shape(), 1);
}

TEST(StepPoles, NorInsideAHollowBall) {
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(ball(), BRepPrimAPI_MakeSphere(48).Shape()).Shape();
  expect_whole(BRepAlgoAPI_Cut(hollow, rod({1, 0, 0})).Shape(), 2);
}

/// Without all that is behind a plane through its axis and below a height: its border leads through one of its poles.
TopoDS_Shape without_back(const TopoDS_Shape& body) {
  return BRepAlgoAPI_Cut(body, BRepPrimAPI_MakeBox(gp_Pnt{-100, -100, -100}, 100, 200, 130).Shape()).Shape();
}

TopoDS_Shape ellipsoid(double x, double y, double z) {
  gp_GTrsf scale;
  scale.SetVectorialPart(gp_Mat(x, 0, 0, 0, y, 0, 0, 0, z));
  return BRepBuilderAPI_GTransform(ball(), scale).Shape();
}

TEST(StepPoles, NorWhereTheBorderLeadsThroughTheOther) {
  expect_whole(without_back(ball()), 1);
  expect_whole(without_back(ellipsoid(1.9, 1.1, 1)), 1, 0.01);
  expect_whole(without_back(ellipsoid(1, 1.5, 0.8)).Reversed(), 1, 0.01);
}

// The kernel makes a face of each hole; what is read whole instead loses images where it is mended.
TEST(StepPoles, NorOfAnEllipsoidWithRodsThroughIt) {
  auto rod_along_y = [](double x, double z, double radius) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2({x, -150, z}, {0, 1, 0}), radius, 300).Shape();
  };
  const TopoDS_Shape one = BRepAlgoAPI_Fuse(ellipsoid(1.897, 1.246, 1.569), rod_along_y(-1.74, -4.23, 22.33)).Shape();
  expect_whole(BRepAlgoAPI_Fuse(one, rod_along_y(-6.63, 29.73, 7.42)).Shape(), 1, 0.01);
}

TEST(StepPoles, BodiesWithAPoleOnTheBorderAreMeshedEvenly) {
  const RunReport report = test::report_of(without_back(ellipsoid(1.9, 1.1, 1)), 10);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_LT(test::longest_side(report), 16);
  EXPECT_LE(report.quality.triangles, 2);
}

/// Of one face, with a point at either end.
TopoDS_Shape spindle() {
  TColgp_Array1OfPnt points(1, 4);
  points(1) = {0, 0, -50}, points(2) = {30, 0, -30}, points(3) = {35, 0, 10}, points(4) = {0, 0, 45};
  const TopoDS_Edge meridian = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points, 3, 3).Curve()).Edge();
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  builder.Add(shell, BRepPrimAPI_MakeRevol(meridian, gp::OZ()).Shape());
  return BRepBuilderAPI_MakeSolid(shell).Solid();
}

// No quads are laid in advance about a point that the border leads through.
TEST(StepPoles, SoAreThoseThatComeToAPointThere) {
  const TopoDS_Shape quarter = BRepPrimAPI_MakeBox(gp_Pnt{0, 0, 0}, 100, 100, 100).Shape();
  for (const double size : {5.0, 10.0, 1000.0}) {
    const RunReport report = test::report_of(BRepAlgoAPI_Cut(spindle(), quarter).Shape(), size);
    EXPECT_STREQ(verdict(report), "sound") << size;
  }
}

// Below the notch the face goes round; the periodic edge ends in the notch or in the point.
TEST(StepPoles, ConesWithANotchThroughTheirPointAreMeshed) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, 20).Shape();
  for (const double turn : {0.0, M_PI}) {
    const gp_Ax2 place({0, 0, 4}, gp::DZ(), gp_Dir(std::cos(turn), std::sin(turn), 0));
    const TopoDS_Shape notched = BRepAlgoAPI_Cut(cone, BRepPrimAPI_MakeCylinder(place, 30, 30, 3).Shape()).Shape();
    for (const double size : {1.0, 2.0, 8.0, 20.0}) {
      const RunReport report = test::report_of(notched, size);
      EXPECT_STREQ(verdict(report), "sound") << size;
      EXPECT_GT(report.quality.sj_all.min, 0.3) << size;
    }
  }
}

// In the chart of a slim cone places along one facet differ by orders of magnitude: a border near the point is not in
// it.
TEST(StepPoles, SlimConesCutBesideTheirPointHaveIt) {
  for (const double radius : {2.0, 4.0, 8.0}) {
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(radius, 0, 40).Shape();
    const TopoDS_Shape cut =
        BRepAlgoAPI_Cut(cone, BRepPrimAPI_MakeBox(gp_Pnt{0.3, -50, -10}, 100, 100, 100).Shape()).Shape();
    const RunReport report = test::report_of(cut, 1e6);
    EXPECT_STREQ(verdict(report), "sound") << radius;
    EXPECT_NEAR(report.quality.mesh_area, report.model.area, 8e-3 * report.model.area) << radius;
  }
}

TEST(StepPoles, FacesThatAreReadRightStay) {
  expect_whole(ball(), 0);
  expect_whole(BRepAlgoAPI_Cut(ball(), rod({0, 1, 0})).Shape(), 0);
  expect_whole(BRepAlgoAPI_Cut(ball(), rod({0, 0, 1})).Shape(), 0);
  expect_whole(BRepAlgoAPI_Cut(rod({0, 0, 1}, 40), rod({1, 0, 0.5})).Shape(), 0);
}

}  // namespace
}  // namespace paver
