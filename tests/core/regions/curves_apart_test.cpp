// Whether curves meet where their chords do: arcs whose distance is known.
#include "regions/curves_apart.h"

#include <gtest/gtest.h>

#include <cmath>

namespace paver {
namespace {

PlaneCurve arc(Vec2 centre, double radius, double from, double to) {
  auto at = [=](double t) {
    const double angle = from + t * (to - from);
    return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
  };
  return {at(0), at(1), at};
}

PlaneCurve line(Vec2 a, Vec2 b) { return {a, b, nullptr}; }

Meeting::Kind meeting(const PlaneCurve& one, const PlaneCurve& other, const std::vector<SharedEnd>& shared = {}) {
  return find_meeting(one, other, shared).kind;
}
constexpr auto apart = Meeting::Kind::apart, meet = Meeting::Kind::meet, near = Meeting::Kind::near;

TEST(CurvesApart, ArcsAsideOneAnotherAreToldApartHoweverNear) {
  for (double gap : {1e-1, 1e-3, 1e-5}) {
    EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1.5), arc({0, 0}, 1 + gap, 0.4, 1.9)), apart) << gap;
    EXPECT_EQ(meeting(arc({0, 0}, 1, -0.7, 0.7), line({1 + gap, -1}, {1 + gap, 1})), apart) << gap;
    EXPECT_EQ(meeting(line({1 + gap, -1}, {1 + gap, 1}), arc({0, 0}, 1, -0.7, 0.7)), apart) << gap;
  }
}

TEST(CurvesApart, ALongGapTooNarrowToFollowIsNear) {
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1.5), arc({0, 0}, 1 + 1e-8, 0.4, 1.9)), near);
}

TEST(CurvesApart, CurvesThatCrossMeetWhereTheyDo) {
  const Meeting found = find_meeting(arc({0, 0}, 5, 0, 1.5), line({0, 0}, {6, 8}), {});
  EXPECT_EQ(found.kind, meet);
  EXPECT_LE(norm(found.at - Vec2{3, 4}), 1e-7);
  EXPECT_EQ(meeting(arc({0, 0}, 1, -0.7, 0.7), line({0.999, -1}, {0.999, 1})), meet);
}

TEST(CurvesApart, CurvesThatTouchOrLieOnOneAnotherMeet) {
  EXPECT_EQ(meeting(arc({0, 0}, 1, -0.7, 0.7), line({1, -1}, {1, 1})), meet);
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1), arc({0, 0}, 1, 0.5, 1.5)), meet);
  EXPECT_EQ(meeting(line({0, 0}, {2, 0}), line({1, 0}, {3, 0})), meet);
}

TEST(CurvesApart, AnEndInCommonIsNoMeeting) {
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1), arc({0, 0}, 1, 1, 2), {{1, 0}}), apart);
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1), arc({2, 0}, 1, 3.141592653589793, 2), {{0, 0}}), apart);
  // Tangent there.
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1), arc({-1, 0}, 2, 0, 0.6), {{0, 0}}), apart);
  EXPECT_EQ(meeting(arc({0, 0}, 1, 0, 1), arc({0, 0}, 1, 0, 0.6), {{0, 0}}), meet);
  // Both ends in common: a lens.
  const double half = 0.5;
  const PlaneCurve low = arc({0, 1}, 1, -1.5707963267948966 - half, -1.5707963267948966 + half);
  PlaneCurve high = line(low.start, low.end);
  EXPECT_EQ(meeting(low, high, {{0, 0}, {1, 1}}), apart);
  EXPECT_EQ(meeting(low, low, {{0, 0}, {1, 1}}), meet);
}

TEST(CurvesApart, ACurveThatJumpsEndsTheSearch) {
  PlaneCurve broken = line({0, 0}, {2, 0});
  broken.at = [](double t) { return Vec2{2 * t, t < 0.3 ? 0.0 : 1.0}; };
  EXPECT_EQ(meeting(broken, line({0.6, -1}, {0.6, 2})), meet);
}

}  // namespace
}  // namespace paver
