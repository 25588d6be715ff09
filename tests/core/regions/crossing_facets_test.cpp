// Pairs of facets that cross against all pairs one by one, and the rules for nodes in common.
#include "regions/crossing_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/planar_region.h"

namespace paver {
namespace {

using Points = std::vector<Vec2>;
constexpr std::size_t all = 1000000;

std::size_t pairs(const std::vector<Points>& loops) {
  return crossing_facets(test::planar_region(loops, 1), all).size();
}

const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(CrossingFacets, SimpleLoopsHaveNone) {
  EXPECT_EQ(pairs({square}), 0u);
  EXPECT_EQ(pairs({test::divided(square, 0.1), test::reversed(test::circle({2, 2}, 1, 100))}), 0u);
  EXPECT_EQ(pairs({}), 0u);
}

TEST(CrossingFacets, FacetsThatCrossOrTouchAreFound) {
  EXPECT_EQ(pairs({{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}), 1u);
  EXPECT_EQ(pairs({{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}), 2u);  // a node on a facet: both its own facets
  EXPECT_EQ(pairs({square, {{1, 1}, {1, 3}, {5, 3}, {5, 1}}}), 2u);  // a hole across a side
  EXPECT_EQ(pairs({square, {{4, 1}, {5, 2}, {4, 3}, {3, 2}}}), 4u);  // two nodes on a side
  EXPECT_EQ(pairs({{{0, 0}, {4, 0}, {2, 0}, {2, 4}}}), 2u);          // folds back on itself
}

TEST(CrossingFacets, LoopsMayTouchInANodeOfBoth) {
  EXPECT_EQ(pairs({{{0, 0}, {4, 0}, {4, 1}, {4, 4}, {0, 4}}, {{4, 1}, {2, 1}, {3, 2}}}), 0u);
}

TEST(CrossingFacets, ASlitIsNoCrossing) {
  EXPECT_EQ(pairs({{{0, 0}, {2, 0}, {2, 1}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}), 0u);
}

// As along a rod that another touches, where its border has far shorter facets than that line.
TEST(CrossingFacets, SidesOfASlitFarLongerThanTheFacetsAboutItAreTwoNodes) {
  Region region = test::planar_region({{{0, 0}, {2, 0}, {2, 1000}, {2 + 3e-7, 0}, {4, 0}, {4, 2000}, {0, 2000}}}, 1);
  std::vector<LoopNode>& loop = region.loops[0];
  loop[3].global = loop[1].global;
  const std::vector<int> nodes = number_loop_nodes(region).of_loop[0];
  EXPECT_NE(nodes[1], nodes[3]);
  loop[3].p = loop[1].p;
  EXPECT_EQ(number_loop_nodes(region).of_loop[0][3], nodes[1]);
}

TEST(CrossingFacets, LoopsInOnePlaceAreFound) {
  Region region = test::planar_region({square, square}, 1);
  EXPECT_EQ(crossing_facets(region, all).size(), 4u);
  region = test::planar_region({square, test::reversed(square)}, 1);
  for (LoopNode& node : region.loops[1]) node.edge = 1;
  EXPECT_EQ(crossing_facets(region, all).size(), 4u);
}

TEST(CrossingFacets, AFacetThatCutsAPointOffIsFound) {
  const Points coarse = test::circle({0, 0}, 4, 6);
  for (double reach : {3.4, 3.5}) {  // the chords are 3.464 from the middle
    Region region = test::planar_region({coarse}, 1);
    const Vec2 at = reach * Vec2{std::cos(M_PI / 2), std::sin(M_PI / 2)};
    Fan& fan = region.fans.emplace_back();
    fan.centre.p = at;
    for (Vec2 p : test::circle(at, 0.01, 8)) {
      fan.ring.emplace_back();
      fan.ring.back().p = p;
    }
    const auto found = crossing_facets(region, all);
    ASSERT_EQ(found.size(), reach > 3.464 ? 1u : 0u);
    if (found.empty()) continue;
    EXPECT_EQ(found[0][0].place, 1);
    EXPECT_EQ(found[0][1].loop, 1);
  }
}

TEST(CrossingFacets, AreThoseOfAllPairs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 100), step(-2, 2);
  for (int round = 0; round < 20; ++round) {
    Points points{{coordinate(random), coordinate(random)}};
    while (points.size() < 300) points.push_back(points.back() + Vec2{step(random), step(random)});
    const Region region = test::planar_region({points}, 1);
    const auto found = crossing_facets(region, all);
    std::vector<std::array<int, 2>> expected;
    auto side = [&](int a, int b, int c) {
      const Vec2 p = points[static_cast<std::size_t>(a)];
      return cross(points[static_cast<std::size_t>(b)] - p, points[static_cast<std::size_t>(c)] - p) > 0;
    };
    for (int i = 0; i < 300; ++i)
      for (int j = i + 2; j < 300; ++j) {
        const int k = (i + 1) % 300, l = (j + 1) % 300;
        if (l != i && side(i, k, j) != side(i, k, l) && side(j, l, i) != side(j, l, k)) expected.push_back({i, j});
      }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_EQ((std::array{found[i][0].place, found[i][1].place}), expected[i]);
    EXPECT_EQ(crossing_facets(region, 5).size(), std::min<std::size_t>(5, found.size()));
  }
}

}  // namespace
}  // namespace paver
