// Parts that all but touch, told by their meshes.
#include "check/distance/gaps.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::report_of;

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

TopoDS_Shape fuse(const TopoDS_Shape& a, const TopoDS_Shape& b) { return BRepAlgoAPI_Fuse(a, b).Shape(); }

TEST(Gaps, PartsWithinAHundredthOfTheTargetLengthAreNamed) {
  const RunReport report = report_of(compound({box(0, 0, 0, 4, 4, 1), box(1, 1, 1.008, 2, 2, 1)}), 1);
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_EQ(report.gaps[0].parts, (std::array<std::string, 2>{"Solid1", "Solid2"}));
  EXPECT_NEAR(report.gaps[0].distance, 0.008, 1e-9);
  EXPECT_STREQ(verdict(report), "doubtful");
  EXPECT_TRUE(faults(report).empty());
}

TEST(Gaps, WiderOnesAndPartsThatTouchAreNot) {
  EXPECT_TRUE(report_of(compound({box(0, 0, 0, 4, 4, 1), box(1, 1, 1.012, 2, 2, 1)}), 1).gaps.empty());
  const RunReport report = report_of(compound({box(0, 0, 0, 4, 4, 1), box(1, 1, 1, 2, 2, 1)}), 1);
  EXPECT_TRUE(report.gaps.empty());
  EXPECT_STREQ(verdict(report), "sound");
}

TEST(Gaps, ACylinderBesideABoxIsNearAlongALineBetweenNodes) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6.009, 2, 0), gp_Dir(0, 0, 1)), 2, 3).Shape();
  const RunReport report = report_of(compound({box(0, 0, 0, 4, 4, 3), cylinder}), 1);
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_NEAR(report.gaps[0].distance, 0.009, 1e-3);
}

// They stand on one another in a corner, which is no reason to touch elsewhere unconnected.
TEST(Gaps, PartsWithOnlyAPointInCommonMayBeNearElsewhere) {
  const TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(9, 8, 0.0005));
  const RunReport near = report_of(compound({box(0, 0, -1, 10, 10, 1), edge}), 1);
  ASSERT_EQ(near.gaps.size(), 1u);
  EXPECT_GT(norm(near.gaps[0].where), 1);
  EXPECT_STREQ(verdict(near), "doubtful");
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(5, 5, 40), 40).Shape();
  EXPECT_TRUE(report_of(compound({box(0, 0, -1, 10, 10, 1), ball}), 1).gaps.empty());
}

// A bracket that stands on a plate with one foot; the other ends just above it.
TEST(Gaps, PartsThatTouchMayBeNearElsewhere) {
  auto bracket = [](double above) {
    return compound({box(0, 0, -1, 20, 4, 1),
                     fuse(fuse(box(1, 1, 0, 2, 2, 3), box(1, 1, 3, 18, 2, 1)), box(17, 1, above, 2, 2, 3.5 - above))});
  };
  const RunReport near = report_of(bracket(0.0005), 1);
  ASSERT_EQ(near.gaps.size(), 1u);
  EXPECT_NEAR(near.gaps[0].distance, 0.0005, 1e-9);
  EXPECT_GE(near.gaps[0].where.x, 17 - 1e-9);
  EXPECT_STREQ(verdict(near), "doubtful");
  EXPECT_EQ(near.components.size(), 1u);
  EXPECT_TRUE(report_of(bracket(0), 1).gaps.empty());
  EXPECT_TRUE(report_of(bracket(0.005), 1).gaps.empty());
}

TEST(Gaps, PartsThatRunIntoEachOtherByLittleAreNamed) {
  auto boxes = [](double depth) { return compound({box(0, 0, 0, 4, 4, 4), box(1, 1, 4 - depth, 2, 2, 2)}); };
  const RunReport report = report_of(boxes(0.0004), 0.5);
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_NEAR(report.gaps[0].distance, 0.0004, 1e-9);
  EXPECT_STREQ(verdict(report), "doubtful");
  EXPECT_TRUE(report_of(boxes(0.005), 0.5).gaps.empty());
}

TEST(Gaps, WiresThatPassEachOtherAreNear) {
  const TopoDS_Shape a = BRepBuilderAPI_MakeEdge(gp_Pnt(-3.3, 0, 0), gp_Pnt(4, 0, 0));
  const TopoDS_Shape b = BRepBuilderAPI_MakeEdge(gp_Pnt(0, -3.2, 0.004), gp_Pnt(0, 4, 0.004));
  const RunReport report = report_of(compound({a, b}), 1);
  ASSERT_EQ(report.gaps.size(), 1u);
  EXPECT_NEAR(report.gaps[0].distance, 0.004, 1e-9);
}

// A slab thinner than the gap that is told: what is above it and what is below it have the slab between them.
TEST(Gaps, TheTwoSidesOfASlabAreNone) {
  const RunReport report =
      report_of(compound({box(0, 0, 0, 2, 2, 1), box(0, 0, 1, 2, 2, 0.006), box(0, 0, 1.006, 2, 2, 1)}), 1);
  EXPECT_TRUE(report.gaps.empty());
}

// A trace of some thickness on a board that lies on a ground plane: its top is near to the ground as well.
TEST(Gaps, WhatASolidLiesBetweenIsNone) {
  const TopoDS_Shape ground = box(0, 0, -1, 4, 4, 1), trace = box(1, 1, 0.006, 2, 2, 0.002);
  EXPECT_TRUE(report_of(compound({ground, box(0, 0, 0, 4, 4, 0.006), trace}), 1).gaps.empty());
  const RunReport without_board = report_of(compound({ground, trace}), 1);
  ASSERT_EQ(without_board.gaps.size(), 1u);
  EXPECT_NEAR(without_board.gaps[0].distance, 0.006, 1e-9);
}

}  // namespace
}  // namespace paver
