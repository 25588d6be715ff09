// Counts of opposite sides after tying.
#include "boundary/facing/tie_sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Counts per edge after tying, from wishes.
std::vector<int> tied(const Model& model, const std::vector<double>& wishes, int minimum = 1, bool are_short = false,
                      std::size_t first_short = 0) {
  std::vector<std::vector<Loop>> loops;
  for (std::size_t f = 0; f < model.faces.size(); ++f) loops.push_back(linked_loops(model, static_cast<int>(f)));
  std::vector<EdgeCount> counts;
  for (double wish : wishes)
    counts.push_back({wish, minimum, std::max(minimum, static_cast<int>(wish + 0.5)), false,
                      are_short && counts.size() >= first_short});
  TiedCounts result = tie_opposite_sides(model, find_opposite_sides(model, loops), loops, counts);
  std::vector<int> chosen;
  for (int group : result.group) chosen.push_back(result.groups[static_cast<std::size_t>(group)].count);
  return chosen;
}

Model square() { return fake::polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}); }

/// Flat ring between two circles: edges 0 outside, 1 inside.
int add_ring(fake::Builder& builder, int outer, int inner, double area) {
  return builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), area,
                      {{builder.use(outer)}, {builder.use(inner, true)}});
}

int add_circle(fake::Builder& builder, double radius) {
  int v = builder.vertex({radius, 0, 0});
  return builder.arc({}, radius, 0, 2 * fake::pi, v, v);
}

TEST(TieSides, BothPairsOfAFaceMayChangeByTwelvePercent) {
  EXPECT_EQ(tied(square(), {40, 50, 46, 50}), (std::vector<int>{43, 50, 43, 50}));
}

TEST(TieSides, NothingIsTiedBeyondThat) {
  EXPECT_EQ(tied(square(), {40, 50, 55, 50}), (std::vector<int>{40, 50, 55, 50}));
}

TEST(TieSides, AFaceThatStaysIrregularIsTiedByRoundingOnly) {
  EXPECT_EQ(tied(square(), {40, 30, 44, 50}), (std::vector<int>{40, 30, 44, 50}));
  EXPECT_EQ(tied(square(), {40.4, 30, 40.6, 50}), (std::vector<int>{41, 30, 41, 50}));
}

TEST(TieSides, SidesOfOneRowDifferInLengthAsRimsDo) {
  auto strip = [](double width) { return fake::polygon({{0, 0, 0}, {30, 0, 0}, {29, width, 0}, {1, width, 0}}); };
  EXPECT_EQ(tied(strip(2), {10, 1, 7.4, 1}), (std::vector<int>{9, 1, 9, 1}));
  EXPECT_EQ(tied(strip(6), {10, 1, 7.4, 1}), (std::vector<int>{10, 1, 7, 1}));
}

TEST(TieSides, EdgesShorterThanTheTargetLengthTakeTwiceTheirCountForAGrid) {
  EXPECT_EQ(tied(square(), {3.2, 2, 1, 2}), (std::vector<int>{3, 2, 1, 2}));
  EXPECT_EQ(tied(square(), {2.8, 2, 1, 2}, 1, true), (std::vector<int>{2, 2, 2, 2}));
  EXPECT_EQ(tied(square(), {9, 2, 5, 2}, 1, true), (std::vector<int>{9, 2, 5, 2})) << "four at most";
}

TEST(TieSides, AnEdgeOfAThinFaceTakesWhatItFaces) {
  // Five edges of one interval each above one of 1.2 target lengths.
  const Model thin = fake::polygon(
      {{0, 0, 0}, {30, 0, 0}, {30, 0.1, 0}, {9, 0.1, 0}, {8.5, 0.1, 0}, {3, 0.1, 0}, {2.5, 0.1, 0}, {0, 0.1, 0}});
  EXPECT_EQ(tied(thin, {1.2, 0.1, 0.8, 0.1, 0.2, 0.1, 0.1, 0.1}), (std::vector<int>{5, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(TieSides, AnEdgeTakesWhatThoseItFacesCanShareByTheirLengths) {
  const Model halves = fake::polygon({{0, 0, 0}, {30, 0, 0}, {30, 0.1, 0}, {15, 0.1, 0}, {0, 0.1, 0}});
  EXPECT_EQ(tied(halves, {11, 0.1, 5.6, 5.4, 0.1}), (std::vector<int>{10, 1, 5, 5, 1}));
  EXPECT_EQ(tied(halves, {11.2, 0.1, 5.8, 5.4, 0.1}), (std::vector<int>{12, 1, 6, 6, 1}));
  const Model thirds = fake::polygon({{0, 0, 0}, {30, 0, 0}, {30, 0.1, 0}, {10, 0.1, 0}, {0, 0.1, 0}});
  EXPECT_EQ(tied(thirds, {11, 0.1, 7.2, 3.8, 0.1}), (std::vector<int>{12, 1, 8, 4, 1}));
}

TEST(TieSides, ItTakesAsManyAsThereAre) {
  std::vector<Vec3> corners{{0, 0, 0}, {30, 0, 0}};
  for (int i = 20; i >= 0; --i) corners.push_back({1.5 * i, 0.1, 0});
  std::vector<double> wishes(corners.size(), 0.1);
  wishes[0] = 1.2;
  EXPECT_EQ(tied(fake::polygon(corners), wishes)[0], 20);
}

TEST(TieSides, TheMinimumHolds) {
  std::vector<int> counts = tied(square(), {7.2, 9, 7.9, 9}, 8);
  EXPECT_EQ(counts, (std::vector<int>{8, 9, 8, 9}));
}

TEST(TieSides, TheCirclesOfAThinRingGetOneEvenCount) {
  for (double width : {0.02, 0.06, 0.15})
    for (double n : {20.4, 31.2, 41.0, 43.9}) {
      fake::Builder builder;
      int outer = add_circle(builder, 1), inner = add_circle(builder, 1 - width);
      add_ring(builder, outer, inner, 1);
      std::vector<int> counts = tied(builder.take(), {n, n * (1 - width)});
      EXPECT_EQ(counts[0], counts[1]) << n << " " << width;
      EXPECT_EQ(counts[0] % 2, 0);
      EXPECT_LE(std::fabs(counts[0] / n - 1), 0.121);
    }
}

TEST(TieSides, TheCirclesOfARingTakeOneCountWhileLengthsStayWithinAQuarterOfTheTarget) {
  for (double ratio : {1.2, 1.4, 1.6, 1.8, 2.5})
    for (double n : {32.0, 61.3, 200.8}) {
      fake::Builder builder;
      int outer = add_circle(builder, 1), inner = add_circle(builder, 1 / ratio);
      add_ring(builder, outer, inner, 1);
      std::vector<int> counts = tied(builder.take(), {n, n / ratio});
      EXPECT_EQ(counts[0] == counts[1], ratio < 1.66) << n << " " << ratio;
      EXPECT_GE(n / counts[0], 0.98);
      EXPECT_LE(n / counts[0], 1.25);
      EXPECT_GE(n / ratio / counts[1], 0.75);
      EXPECT_EQ(counts[0] % 2, 0);
    }
}

TEST(TieSides, ARimShorterThanTheTargetLengthTakesAsManyAsTheOtherEndOfItsRod) {
  for (bool is_short : {false, true}) {
    fake::Builder builder;
    int one = add_circle(builder, 0.1), other = add_circle(builder, 0.05);
    add_ring(builder, one, other, 1);
    const std::vector<int> counts = tied(builder.take(), {8, 4.8}, 1, is_short);
    EXPECT_EQ(counts[0] == counts[1], is_short);
    EXPECT_EQ(counts[0], 8);
  }
}

// A rod ends on a dish: with 12 intervals round the dish, as many on the common rim, there were 5 on the other.
TEST(TieSides, RimsOfARodAreTiedToEachOtherBeforeALongRim) {
  fake::Builder builder;
  const int dish = add_circle(builder, 1), rim = add_circle(builder, 0.1), end = add_circle(builder, 0.09);
  add_ring(builder, dish, rim, 3);
  add_ring(builder, rim, end, 1);
  const std::vector<int> counts = tied(builder.take(), {12.6, 7.6, 5.1}, 5, true, 1);
  EXPECT_EQ(counts[1], counts[2]);
  EXPECT_EQ(counts[1], 8);
  EXPECT_EQ(counts[0], 12);
}

// Around a pin: the pin's rims take ten, as its length is; the ring with eight outside had needles.
TEST(TieSides, RimsOfAThinRingTakeOneCountBeforeAllOthers) {
  fake::Builder builder;
  const int outer = add_circle(builder, 1.1), rim = add_circle(builder, 1), end = add_circle(builder, 1);
  add_ring(builder, outer, rim, 0.66);
  add_ring(builder, rim, end, 20);
  const std::vector<int> counts = tied(builder.take(), {7.48, 10.2, 10.2}, 8);
  EXPECT_EQ(counts, (std::vector<int>(3, 10)));
}

TEST(TieSides, SidesOfACrescentTakeOneCountWhereItIsThin) {
  const Model model = fake::polygon({{-10, 0, 0}, {0, -0.1, 0}, {10, 0, 0}, {0, 0.1, 0}});
  const std::vector<int> thin = tied(model, {3.4, 3.4, 3.6, 3.6}), wide = tied(model, {34, 34, 36, 36});
  EXPECT_EQ(thin[0] + thin[1], thin[2] + thin[3]);
  EXPECT_EQ(wide, (std::vector<int>{34, 34, 36, 36}));
}

TEST(TieSides, SidesOfAMoonTakeOneCountWhereOneRowFillsIt) {
  EXPECT_EQ(tied(fake::moon(10, 9), {31.4, 28.3}), (std::vector<int>{30, 30})) << "half as wide as intervals are long";
  EXPECT_EQ(tied(fake::moon(10, 8), {62.8, 50.3}), (std::vector<int>{62, 50})) << "twice as wide";
}

TEST(TieSides, SidesOfAThinRingWithCornersTakeOneCount) {
  const std::vector<double> wishes{1.6, 1.6, 1.6, 1.6, 1.4, 1.4, 1.4, 1.4};
  const std::vector<int> narrow = tied(fake::frame(4, 0.1), wishes),
                         wide = tied(fake::frame(4, 0.4), {16, 16, 16, 16, 13, 13, 13, 13});
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(narrow[k], narrow[k + 4]);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NE(wide[k], wide[k + 4]) << "there is room for more than one row";
}

TEST(TieSides, ChainsOfRingsTakeOneCountWhileItFitsAll) {
  fake::Builder builder;
  std::vector<int> circles;
  for (double radius : {1.0, 0.92, 0.98, 0.9, 1.0}) circles.push_back(add_circle(builder, radius));
  for (std::size_t i = 1; i < circles.size(); ++i) add_ring(builder, circles[i - 1], circles[i], 1);
  EXPECT_EQ(tied(builder.take(), {41, 37.7, 40.2, 36.9, 41}), (std::vector<int>(5, 40)));
}

TEST(TieSides, ALongChainIsBrokenWhereItsFacesAreSmallest) {
  fake::Builder builder;
  std::vector<int> circles;
  for (double radius : {1.0, 0.75, 0.55}) circles.push_back(add_circle(builder, radius));
  add_ring(builder, circles[0], circles[1], 1);
  add_ring(builder, circles[1], circles[2], 2);
  std::vector<int> counts = tied(builder.take(), {40, 30, 22});
  EXPECT_EQ(counts[1], counts[2]);
  EXPECT_EQ(counts[0], 40);
}

// Three edges below that meet at 10 and 11; on top from 30 back three that meet at 25 and 24.
TEST(TieSides, EdgesOfAThinFaceAreNoneOfAnotherThatDoNotFaceThem) {
  const Model model = fake::polygon(
      {{0, 0, 0}, {10, 0, 0}, {11, 0, 0}, {30, 0, 0}, {30, 0.1, 0}, {25, 0.1, 0}, {24, 0.1, 0}, {0, 0.1, 0}});
  EXPECT_EQ(tied(model, {2, 1, 3, 1, 1, 1, 4, 1}, 1, true), (std::vector<int>{2, 1, 3, 1, 1, 1, 4, 1}));
}

TEST(TieSides, SidesOfUnequalNumbersOfEdgesGetEqualSums) {
  Model model = fake::polygon({{0, 0, 0}, {3, 0, 0}, {6, 0, 0}, {6, 4, 0}, {0, 4, 0}});
  std::vector<int> counts = tied(model, {15, 15.4, 20, 32, 20});
  EXPECT_EQ(counts[0] + counts[1], counts[3]);
  EXPECT_NEAR(counts[3], 31, 1);
}

}  // namespace
}  // namespace paver
