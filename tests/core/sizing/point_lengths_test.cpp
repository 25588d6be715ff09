// Target lengths at points, before anything is meshed.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
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
