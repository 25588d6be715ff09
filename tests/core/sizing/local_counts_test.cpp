// Predictions beside the meshes they are of, and apexes, on bodies with tips.
#include "sizing/parts/local_counts.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <cmath>
#include <gp.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

/// 2 `half` long, of one face without a border.
TopoDS_Shape spindle(double half, double radius) {
  const gp_Pnt low(0, 0, -half), side(radius, 0, 0), high(0, 0, half);
  const TopoDS_Edge profile = BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(low, side, high).Value());
  return BRepPrimAPI_MakeRevol(profile, gp::OZ()).Shape();
}

TEST(LocalCounts, TurnsAboutTipsCountOnFacesWithoutABorder) {
  for (double radius : {3.0, 8.0, 25.4})
    for (double h : {4.0, 9.0, 14.0}) {
      const RunReport report = test::report_of(spindle(127, radius), h);
      const auto elements = static_cast<double>(report.quality.quads + report.quality.triangles);
      EXPECT_NEAR(elements / report.quality.metric.predicted, 1, 0.25) << radius << " " << h;
      EXPECT_EQ(report.quality.triangles, 0) << radius << " " << h;
    }
}

TEST(LocalCounts, BluntApexesHaveFourQuadsNearTheSurface) {
  for (double half_angle : {31.0, 43.6, 55.0}) {
    constexpr double radius = 50, h = 7;
    const double height = radius / std::tan(half_angle * std::numbers::pi / 180);
    const RunReport report = test::report_of(BRepPrimAPI_MakeCone(radius, 0, height).Shape(), h);
    EXPECT_LT(report.quality.distance.largest, 0.02 * h) << half_angle;
    EXPECT_EQ(report.quality.triangles, 0) << half_angle;
  }
}

}  // namespace
}  // namespace paver
