// Vertices that lie close before long straight edges: where these get nodes.
#include "boundary/border/opposite_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "boundary/border/border_facets.h"
#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

struct Faced {
  std::vector<EdgeCount> counts;
  std::vector<std::vector<double>> opposite;
};

/// Of a polygon whose edges have one interval each.
Faced faced(const std::vector<Vec3>& points) {
  const Model model = fake::polygon(points);
  Faced result{std::vector<EdgeCount>(points.size(), {1, 1, 1}), {}};
  result.opposite = face_near_vertices(model, {linked_loops(model, 0)}, result.counts);
  return result;
}

/// A strip of 100 x 2 with a tooth from `left` to 50, `up` high.
std::vector<Vec3> tooth(double left, double up = 40) {
  return {{0, 0, 0}, {100, 0, 0}, {100, 2, 0}, {50, 2, 0}, {50, up, 0}, {left, up, 0}, {left, 2, 0}, {0, 2, 0}};
}

TEST(OppositeVertices, ABaseHasNodesOppositeATooth) {
  const Faced result = faced(tooth(47));
  std::vector<double> places = result.opposite[0];
  std::ranges::sort(places);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(places[0], 0.47, 1e-12);
  EXPECT_NEAR(places[1], 0.50, 1e-12);
  EXPECT_EQ(result.counts[0].count, 3);
  EXPECT_EQ(result.counts[0].minimum, 3);
  for (std::size_t e = 1; e < result.counts.size(); ++e) EXPECT_EQ(result.counts[e].count, 1) << e;
}

TEST(OppositeVertices, VerticesNextToEachOtherAreOne) { EXPECT_EQ(faced(tooth(49.9)).opposite[0].size(), 1u); }

TEST(OppositeVertices, WhatIsFarAwayNeedsNone) {
  const Faced result =
      faced({{0, 0, 0}, {100, 0, 0}, {100, 12, 0}, {50, 12, 0}, {50, 40, 0}, {47, 40, 0}, {47, 12, 0}, {0, 12, 0}});
  EXPECT_EQ(result.opposite, std::vector<std::vector<double>>(8));
}

// Its one corner that is not convex lies opposite the corner of both outer sides.
TEST(OppositeVertices, AnAngleOfEqualLegsNeedsNone) {
  const Faced result = faced({{0, 0, 0}, {100, 0, 0}, {100, 2, 0}, {2, 2, 0}, {2, 100, 0}, {0, 100, 0}});
  EXPECT_EQ(result.opposite, std::vector<std::vector<double>>(6));
}

// A slot between two bodies of the face: its corners are convex seen from there.
TEST(OppositeVertices, NothingIsFacedAcrossASlot) {
  const Faced result =
      faced({{0, 0, 0}, {100, 0, 0}, {100, 30, 0}, {60, 30, 0}, {60, 31, 0}, {100, 31, 0}, {100, 60, 0}, {0, 60, 0}});
  for (int edge : {3, 5}) EXPECT_TRUE(result.opposite[edge].empty());
}

TEST(BorderFacets, SharesAreEvenBetweenPlaces) {
  EXPECT_EQ(shares_of({}, 4), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(shares_of({0.5, 0.25}, 4), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(shares_of({0.125}, 3), (std::vector<double>{0, 0.125, 0.5625, 1}));
}

// Counts may have been lowered since.
TEST(BorderFacets, ThePlacesThatCameFirstAreKept) {
  EXPECT_EQ(shares_of({0.5, 0.25, 0.75}, 2), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(shares_of({0.5}, 1), (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace paver
