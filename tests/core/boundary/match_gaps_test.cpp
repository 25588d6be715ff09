// A square with a round hole: how many intervals both loops get by the width of the gap between them.
#include <gtest/gtest.h>

#include "boundary/facing/raise_counts.h"
#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Edges 0 to 3 are the sides of a square 2 x 2, edge 4 the circle about its middle.
Model pad(double radius) {
  fake::Builder builder;
  const Vec3 middle{1, 1, 0};
  for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{2, 2, 0}, Vec3{0, 2, 0}}) builder.vertex(corner);
  const int on_circle = builder.vertex(middle + Vec3{radius, 0, 0});
  std::vector<std::vector<Coedge>> loops(2);
  for (int i = 0; i < 4; ++i) loops[0].push_back(builder.use(builder.line(i, (i + 1) % 4)));
  loops[1].push_back(builder.use(builder.arc(middle, radius, 0, 2 * fake::pi, on_circle, on_circle), true));
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 4 - fake::pi * radius * radius,
               loops);
  return builder.take();
}

/// Of the four sides, which have `on_side` each, and of the circle, which has `on_circle`, at target length h.
std::pair<std::vector<int>, int> matched(double radius, double h, int on_side, int on_circle) {
  const Model model = pad(radius);
  SizeField size;
  size.h = h, size.face_h = {h};
  std::vector<EdgeCount> counts(4, {1.0 * on_side, 1, on_side});
  counts.push_back({1.0 * on_circle, 4, on_circle});
  match_gaps(model, size, {linked_loops(model, 0)}, counts);
  std::vector<int> sides;
  for (int e = 0; e < 4; ++e) sides.push_back(counts[e].count);
  return {sides, counts[4].count};
}

using Sides = std::vector<int>;

TEST(MatchGaps, SidesOfASmallFaceGetAsManyIntervalsAsItsHole) {
  for (double h : {1.3, 2.0, 5.0}) EXPECT_EQ(matched(0.6, h, 1, 8), std::pair(Sides(4, 2), 8)) << h;
}

TEST(MatchGaps, AHoleGivesUpAnOddIntervalBeforeItsSidesAreDividedForIt) {
  EXPECT_EQ(matched(0.6, 1, 2, 9), std::pair(Sides(4, 2), 8));
}

TEST(MatchGaps, SidesGetUnequalCountsWhereEqualOnesWouldSuitALongHoleBadly) {
  fake::Builder builder;
  for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{2, 2, 0}, Vec3{0, 2, 0}}) builder.vertex(corner);
  for (const Vec3 corner : {Vec3{0.3, 0.9, 0}, Vec3{0.3, 1.1, 0}, Vec3{1.7, 1.1, 0}, Vec3{1.7, 0.9, 0}})
    builder.vertex(corner);
  std::vector<std::vector<Coedge>> loops(2);
  for (std::size_t loop : {0, 1})
    for (int i = 0, first = loop == 0 ? 0 : 4; i < 4; ++i)
      loops[loop].push_back(builder.use(builder.line(first + i, first + (i + 1) % 4)));
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 3.72, loops);
  const Model model = builder.take();
  SizeField size;
  size.h = 5, size.face_h = {2.8};
  std::vector<EdgeCount> counts(4, {1, 1, 1});
  for (int on_hole : {1, 4, 1, 4}) counts.push_back({1.0 * on_hole, on_hole, on_hole});
  match_gaps(model, size, {linked_loops(model, 0)}, counts);
  Sides sides;
  for (int e = 0; e < 4; ++e) sides.push_back(counts[e].count);
  EXPECT_EQ(sides, (Sides{2, 3, 2, 3})) << "ten together; with 3, 3, 2, 2 quads would be needles";
}

TEST(MatchGaps, LeavesFacesFarLargerThanTheTargetLengthAndWideGaps) {
  EXPECT_EQ(matched(0.6, 0.7, 3, 8), std::pair(Sides(4, 3), 8)) << "four target lengths across";
  EXPECT_EQ(matched(0.1, 1.2, 1, 8), std::pair(Sides(4, 1), 8)) << "the gap is 0.9 mm wide";
}

}  // namespace
}  // namespace paver
