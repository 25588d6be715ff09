// Faces of few elements with round borders, where two sides of a quad would be one smooth curve.
#include "repair/edits/row_along.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 10;

gp_Pnt at(double angle) { return {radius * std::cos(angle), radius * std::sin(angle), 0}; }

TopoDS_Edge arc(double angle) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(gp::XOY(), radius), at(-0.5 * angle), at(0.5 * angle));
}

/// The part of a disc between an arc and its chord.
TopoDS_Face segment(double angle) {
  BRepBuilderAPI_MakeWire wire(arc(angle), BRepBuilderAPI_MakeEdge(at(0.5 * angle), at(-0.5 * angle)));
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

/// Between two radii.
TopoDS_Face sector(double angle) {
  const gp_Pnt middle(0, 0, 0);
  BRepBuilderAPI_MakeWire wire(arc(angle), BRepBuilderAPI_MakeEdge(at(0.5 * angle), middle),
                               BRepBuilderAPI_MakeEdge(middle, at(-0.5 * angle)));
  return BRepBuilderAPI_MakeFace(wire.Wire());
}

double worst(const QualityReport& quality) { return std::min(quality.sj_all.min, quality.min_jacobian_ratio); }

TEST(RowAlong, LeavesAnAngleAtEveryNodeOfAnArc) {
  for (double angle : {pi / 3, pi / 2, 0.8 * pi, pi, 1.3 * pi, 1.6 * pi})
    for (double h = 2 * radius; h > 0.1 * radius; h *= 0.85)
      for (const TopoDS_Face& face : {segment(angle), sector(angle)}) {
        const RunReport report = test::report_of(face, h);
        EXPECT_GT(worst(report.quality), 0.1) << angle << " " << h;
        EXPECT_TRUE(report.quality.watertight || report.quality.border_edges > 0);
      }
}

TEST(RowAlong, NeedsNoTriangleInHalfAndQuarterDiscs) {
  for (double h = 1.3 * radius; h > 0.1 * radius; h *= 0.85) {
    EXPECT_EQ(test::report_of(segment(pi), h).quality.triangles, 0) << h;
    EXPECT_EQ(test::report_of(sector(pi / 2), h).quality.triangles, 0) << h;
  }
}

TEST(RowAlong, SmallQuartersAreTwoTriangles) {
  const QualityReport quality = test::report_of(sector(pi / 2), 3 * radius).quality;
  EXPECT_EQ(quality.quads, 0);
  EXPECT_EQ(quality.triangles, 2);
}

TEST(RowAlong, EndsOfBarsAndPartsOfBallsHaveNoFlatElement) {
  for (double h = radius; h > 0.1 * radius; h *= 0.8) {
    const TopoDS_Shape bar = BRepPrimAPI_MakePrism(segment(pi), gp_Vec(0, 0, 30));
    EXPECT_GT(worst(test::report_of(bar, h).quality), 0.25) << h;
    EXPECT_GT(worst(test::report_of(BRepPrimAPI_MakeSphere(radius, 0, pi / 2, pi / 2).Shape(), h).quality), 0.2) << h;
  }
}

// Outlines as numbers of nodes; the chain goes from the second node on, or from the first.
TEST(RowAlong, GivesQuadsAndWhatTheyLeave) {
  const std::array outline{0, 1, 2, 3, 4, 5};
  const std::array made{6, 7};
  const BorderRow row = row_along(outline, {1, 3}, made);
  const std::vector<Corners> quads{{1, 2, 6, 0}, {2, 3, 7, 6}, {3, 4, 5, 7}};
  EXPECT_EQ(row.quads, quads);
  EXPECT_EQ(row.rest, (std::vector{0, 6, 7, 5}));
  EXPECT_TRUE(leaves_filling(outline, {1, 3}));
  EXPECT_FALSE(leaves_filling(std::span(outline).first(4), {0, 2}));
}

TEST(RowAlong, EndsWhereBothEndsHaveTheSameNeighbour) {
  const std::array outline{0, 1, 2, 3, 4, 5};
  const std::array made{6, 7, 8};
  EXPECT_EQ(row_along(outline, {1, 4}, made).rest, (std::vector{0, 6, 7, 8}));
}

}  // namespace
}  // namespace paver
