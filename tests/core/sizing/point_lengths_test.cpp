// Target lengths at points, before anything is meshed.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Surface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"

namespace paver {
namespace {

std::vector<double> lengths(const TopoDS_Shape& shape, Options options, const std::vector<FacePoint>& points) {
  std::ostringstream out;
  BRepTools::Write(shape, out);
  Progress progress;
  return target_lengths(read_bytes(out.str(), "shape", progress), options, points, progress);
}

TEST(PointLengths, AreShorterAcrossARidgeByTheTurnLimit) {
  constexpr double radius = 10, u = 0.7, v = 42;
  const FacePoint on_wall{0, {u, v}, {radius * std::cos(u), radius * std::sin(u), v}};
  Options options;
  options.size = 50;
  for (double limit : {0.2, 0.4}) {
    options.max_turn = limit;
    const double length = lengths(BRepPrimAPI_MakeCylinder(radius, 100).Shape(), options, {on_wall})[0];
    EXPECT_NEAR(length / (limit * radius), 1, 0.3) << limit;
  }
}

// Meshed as the cylinder it is, it keeps the parameters of the spline for whoever asks.
TEST(PointLengths, AreAskedForByTheParametersOfASplineThatIsACylinder) {
  constexpr double radius = 10, share_u = 0.3, share_v = 0.4;
  const TopoDS_Shape spline = BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(radius, 100).Shape()).Shape();
  const TopoDS_Face wall = TopoDS::Face(TopExp_Explorer(spline, TopAbs_FACE).Current());
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRep_Tool::Surface(wall)->Bounds(u0, u1, v0, v1);
  const Vec2 uv{std::lerp(u0, u1, share_u), std::lerp(v0, v1, share_v)};
  const gp_Pnt x = BRep_Tool::Surface(wall)->Value(uv.x, uv.y);
  Options options;
  options.size = 50;
  options.max_turn = 0.4;
  EXPECT_NEAR(lengths(spline, options, {{0, uv, {x.X(), x.Y(), x.Z()}}})[0] / (0.4 * radius), 1, 0.3);
}

TEST(PointLengths, FollowLengthsOfPartsOnPiecesThatOtherPartsHaveInCommon) {
  const TopoDS_Shape boxes = test::compound({BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 40, 40, 40).Shape(),
                                             BRepPrimAPI_MakeBox(gp_Pnt(20, 0, 40), 40, 40, 40).Shape()});
  Options options;
  options.size = 10;
  options.local = {{"Face6", 1.0}};
  const std::vector<double> found =
      lengths(boxes, options,
              {{5, {30, 20}, {30, 20, 40}}, {5, {10, 20}, {10, 20, 40}}, {4, {20, 20}, {20, 20, 0}}, {77, {}, {}}});
  EXPECT_NEAR(found[0], 1, 1e-9) << "where the other box lies on it";
  EXPECT_NEAR(found[1], 1, 1e-9);
  EXPECT_NEAR(found[2], 10, 1e-9) << "far away";
  EXPECT_EQ(found[3], 0) << "there is no such face";
}

}  // namespace
}  // namespace paver
