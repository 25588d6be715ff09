// Which sides of a face lie opposite each other.
#include "boundary/facing/opposite_sides.h"

#include <gtest/gtest.h>

#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

using Side = std::vector<int>;

std::vector<OppositeSides> pairs_of(const Model& model) {
  std::vector<std::vector<Loop>> loops;
  for (std::size_t f = 0; f < model.faces.size(); ++f) loops.push_back(linked_loops(model, static_cast<int>(f)));
  return find_opposite_sides(model, loops);
}

/// Ring in z = 0 between circles of two arcs each: edges 0, 1 outside, 2, 3 inside, these from a quarter turn on.
Model ring_of_arcs(double outer, double inner) {
  fake::Builder builder;
  const double pi = fake::pi;
  int a = builder.vertex({outer, 0, 0}), b = builder.vertex({-outer, 0, 0});
  int c = builder.vertex({inner, 0, 0}), d = builder.vertex({-inner, 0, 0});
  builder.arc({}, outer, 0, pi, a, b);
  builder.arc({}, outer, pi, 2 * pi, b, a);
  builder.arc({}, inner, 0, pi, c, d);
  builder.arc({}, inner, pi, 2 * pi, d, c);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}),
               pi * (outer * outer - inner * inner),
               {{builder.use(0), builder.use(1)}, {builder.use(3, true), builder.use(2, true)}});
  return builder.take();
}

TEST(OppositeSides, OfAQuadrilateralAreItsOppositeEdges) {
  auto pairs = pairs_of(fake::polygon({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}));
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].first, Side{0});
  EXPECT_EQ(pairs[0].second, Side{2});
  EXPECT_EQ(pairs[0].partner, 1);
  EXPECT_EQ(pairs[1].partner, 0);
}

TEST(OppositeSides, RunOverVerticesThatAreNoCorners) {
  auto pairs = pairs_of(fake::polygon({{1, 0, 0}, {4, 0, 0}, {4, 3, 0}, {3, 3, 0}, {1, 3, 0}, {0, 3, 0}, {0, 0, 0}}));
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].first, Side{1});
  EXPECT_EQ(pairs[0].second, Side{5});
  EXPECT_EQ(pairs[1].first, (Side{2, 3, 4}));
  EXPECT_EQ(pairs[1].second, (Side{0, 6})) << "in the direction of the first";
}

TEST(OppositeSides, AreNotSeenWhereACornerTurnsInwards) {
  EXPECT_TRUE(
      pairs_of(fake::polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {3, 3, 0}, {1, 3, 0}, {1, 4, 0}, {0, 4, 0}}))
          .empty());
  EXPECT_TRUE(pairs_of(fake::polygon({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}})).empty()) << "a dart";
}

TEST(OppositeSides, OfAStripThatBendsAreItsStraightParts) {
  const auto pairs =
      pairs_of(fake::polygon({{0, 0, 0}, {6, 0, 0}, {6, 8, 0}, {5.8, 8, 0}, {5.8, 0.2, 0}, {0, 0.2, 0}}));
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].first, Side{3}) << "from the end at the top on";
  EXPECT_EQ(pairs[0].second, Side{1});
  EXPECT_EQ(pairs[1].first, Side{4});
  EXPECT_EQ(pairs[1].second, Side{0});
  EXPECT_NEAR(pairs[1].width, 0.2, 0.01);
  EXPECT_EQ(pairs[1].partner, -1);
}

TEST(OppositeSides, OfACrescentRunFromTipToTip) {
  const auto pairs = pairs_of(fake::polygon({{-10, 0, 0}, {0, -0.1, 0}, {10, 0, 0}, {0, 0.1, 0}}));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].is_crescent);
  EXPECT_EQ(pairs[0].first, (Side{0, 1}));
  EXPECT_EQ(pairs[0].second, (Side{3, 2}));
  EXPECT_NEAR(pairs[0].width, 0.1, 1e-3);
  EXPECT_TRUE(pairs_of(fake::polygon({{-10, 0, 0}, {0, -3, 0}, {10, 0, 0}, {0, 3, 0}})).empty()) << "too wide";
}

TEST(OppositeSides, OfACrescentMayEndInAShortEdge) {
  const auto pairs = pairs_of(fake::polygon({{-10, 0, 0}, {0, -0.2, 0}, {10, -0.01, 0}, {10, 0.01, 0}, {0, 0.2, 0}}));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, (Side{0, 1}));
  EXPECT_EQ(pairs[0].second, (Side{4, 3}));
}

TEST(OppositeSides, OfASlimTriangleRunFromTheTip) {
  const std::vector<OppositeSides> pairs = pairs_of(fake::polygon({{0, 0, 0}, {100, 0, 0}, {0, 8, 0}}));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].is_crescent);
  EXPECT_TRUE(pairs_of(fake::polygon({{0, 0, 0}, {30, 0, 0}, {0, 10, 0}})).empty());
}

TEST(OppositeSides, LoopsThatTouchAreACrescentFromThereOn) {
  const auto pairs = pairs_of(fake::moon(10, 9));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(pairs[0].is_crescent);
  EXPECT_TRUE(pairs[0].is_moon);
  EXPECT_EQ(pairs[0].first, Side{0});
  EXPECT_EQ(pairs[0].second, Side{1});
  EXPECT_NEAR(pairs[0].width, 1, 1e-9);
}

TEST(OppositeSides, OfATubeAreItsEnds) {
  auto pairs = pairs_of(fake::tube(1, 2));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, Side{0});
  EXPECT_EQ(pairs[0].second, Side{2});
  EXPECT_EQ(pairs[0].partner, -1);
}

TEST(OppositeSides, OfARingAreMatchedByWhereTheyLie) {
  auto pairs = pairs_of(ring_of_arcs(3, 2));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, (Side{0, 1}));
  EXPECT_EQ(pairs[0].second, (Side{2, 3}));
}

TEST(OppositeSides, OfAThinRingWithCornersAreItsSides) {
  const auto pairs = pairs_of(fake::frame(4, 0.1));
  ASSERT_EQ(pairs.size(), 4u);
  for (const OppositeSides& pair : pairs) {
    ASSERT_EQ(pair.first.size(), 1u);
    EXPECT_EQ(pair.second, Side{pair.first[0] + 4});
    EXPECT_EQ(pair.partner, -1);
    EXPECT_NEAR(pair.width, 0.1, 1e-9);
  }
  EXPECT_TRUE(pairs_of(fake::frame(4, 1)).empty()) << "too wide";
}

TEST(OppositeSides, ATriangleAndADiskHaveNone) {
  EXPECT_TRUE(pairs_of(fake::polygon({{0, 0, 0}, {4, 0, 0}, {2, 3, 0}})).empty());
  fake::Builder builder;
  int v = builder.vertex({1, 0, 0});
  builder.arc({}, 1, 0, 2 * fake::pi, v, v);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), fake::pi, {{builder.use(0)}});
  EXPECT_TRUE(pairs_of(builder.take()).empty());
}

/// A plate of 30 by 12 with two holes of 10 by 10 and a wall of this width between them. Edges 0 to 3 outside, counter-
/// clockwise from below; 4 to 7 and 8 to 11 about the holes, clockwise from their left sides.
Model two_holes(double wall) {
  fake::Builder builder;
  std::vector<std::vector<Coedge>> loops;
  auto add_loop = [&](const std::vector<Vec2>& corners) {
    std::vector<Coedge>& loop = loops.emplace_back();
    std::vector<int> vertices;
    for (Vec2 p : corners) vertices.push_back(builder.vertex({p.x, p.y, 0}));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t next = (i + 1) % corners.size();
      loop.push_back(builder.use(builder.line(vertices[i], vertices[next]), false, corners[i], corners[next]));
    }
  };
  add_loop({{0, 0}, {30, 0}, {30, 12}, {0, 12}});
  for (double x : {15 - 0.5 * wall - 10, 15 + 0.5 * wall}) add_loop({{x, 1}, {x, 11}, {x + 10, 11}, {x + 10, 1}});
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 30 * 12 - 200, loops);
  return builder.take();
}

TEST(OppositeSides, OfAWallBetweenTwoHolesAreTheEdgesAlongIt) {
  const auto pairs = pairs_of(two_holes(0.4));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first, Side{6});
  EXPECT_EQ(pairs[0].second, Side{8});
  EXPECT_TRUE(pairs[0].is_gap);
  EXPECT_NEAR(pairs[0].width, 0.4, 1e-12);
  EXPECT_TRUE(pairs_of(two_holes(3)).empty()) << "wider than a fifth of its length";
}

}  // namespace
}  // namespace paver
