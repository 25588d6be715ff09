#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "sizing/parts/find_places.h"
#include "support/plates.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::disc, test::plate;

constexpr double gradation = 0.6;

TopoDS_Shape plate_without(const TopoDS_Shape& hole) { return BRepAlgoAPI_Cut(plate(0, 0, 100, 80), hole).Shape(); }

/// Intervals of a fifth of a circle, and as long as straight edges are, up to 40.
std::vector<SizeSource> sources(const TopoDS_Shape& shape) {
  auto interval = [](const Edge& edge, double) {
    return edge.start == edge.end ? edge.length / 5 : std::min(edge.length, 40.0);
  };
  return find_fine_borders(test::model_of(shape), interval, gradation);
}

TEST(FindFineBorders, AHoleBesideAnEdgeWithTheLengthOfItsIntervals) {
  const std::vector<SizeSource> found = sources(plate_without(disc(47, 4, 2)));
  ASSERT_FALSE(found.empty());
  for (const SizeSource& piece : found) {
    EXPECT_NEAR(piece.value, 4 * M_PI / 5, 1e-6);
    EXPECT_NEAR(norm(piece.a - Vec3{47, 4, 0}), 2, 1e-6) << "the plate's own border is none";
  }
}

// About 0.6 x distance against 0.4 of 40.
TEST(FindFineBorders, NoneWhereLengthsGrowFarEnough) {
  EXPECT_FALSE(sources(plate_without(disc(47, 12, 0.5))).empty());
  EXPECT_TRUE(sources(plate_without(disc(47, 30, 0.5))).empty());
  EXPECT_TRUE(sources(plate_without(disc(47, 40, 12))).empty()) << "large as well as far";
}

// Three rings of five columns have room in 0.3 of the distance to the edge.
TEST(FindFineBorders, FarFromOthersLengthsGrowFromWhereRingsOfQuadsEnd) {
  const std::vector<SizeSource> found = sources(plate_without(disc(47, 12, 0.3)));
  ASSERT_FALSE(found.empty());
  const double wider = std::pow(1 + 2 * M_PI / 5, 3);
  for (const SizeSource& piece : found) {
    EXPECT_NEAR(norm(piece.a - Vec3{47, 12, 0}), wider * 0.3, 0.02 * wider * 0.3);
    EXPECT_NEAR(piece.value, wider * 0.3 * 2 * M_PI / 5, 0.02 * wider);
  }
}

TEST(FindFineBorders, OnlyOtherBordersOfTheSameFaceCount) {
  EXPECT_TRUE(sources(plate_without(plate(40, 0, 42, 3))).empty()) << "a notch is part of the border";
  EXPECT_TRUE(sources(plate(0, 0, 100, 80)).empty());
}

TEST(FindFineBorders, OfTwoHolesTheSmallOneBesideTheLarge) {
  const TopoDS_Shape one = BRepAlgoAPI_Cut(plate_without(disc(50, 40, 15)), disc(66, 40, 0.5)).Shape();
  const std::vector<SizeSource> found = sources(one);
  ASSERT_FALSE(found.empty());
  for (const SizeSource& piece : found) EXPECT_NEAR(norm(piece.a - Vec3{66, 40, 0}), 0.5, 1e-6);
}

// The edge's one interval had met the hole's six: slivers of a scaled Jacobian of 0.002, and up to 18 triangles.
TEST(FindFineBorders, AHoleBesideAnEdgeIsMeshedWellAtEverySize) {
  for (const auto& [x, y, radius] : {std::array{47.0, 4.0, 2.0}, {47.0, 1.0, 0.5}, {47.0, 7.2, 6.0}, {4.0, 4.0, 2.0}})
    for (double h : {6.0, 16.0, 40.0, 1e6}) {
      const RunReport report = test::report_of(plate_without(disc(x, y, radius)), h);
      EXPECT_STREQ(verdict(report), "sound");
      EXPECT_GT(report.quality.sj_all.min, 0.15) << x << " " << y << " " << radius << " at " << h;
      EXPECT_LE(report.quality.triangles, 8) << x << " " << y << " " << radius << " at " << h;
    }
}

}  // namespace
}  // namespace paver
