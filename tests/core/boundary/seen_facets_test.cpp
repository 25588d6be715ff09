// Long facets close before nodes: how many intervals their edges get.
#include "boundary/border/seen_facets.h"

#include <gtest/gtest.h>

#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

using Counts = std::vector<int>;

/// Of a plane face whose edges have these counts.
Counts divided(const Model& model, const Counts& before) {
  std::vector<EdgeCount> counts;
  for (int count : before) counts.push_back({1.0 * count, 1, count});
  divide_seen_facets(model, {linked_loops(model, 0)}, std::vector<std::vector<double>>(counts.size()), counts);
  Counts result;
  for (const EdgeCount& count : counts) result.push_back(count.count);
  return result;
}

/// All edges of `points`, with one interval each.
Counts divided(const std::vector<Vec3>& points) { return divided(fake::polygon(points), Counts(points.size(), 1)); }

// A septum: all its quads would meet in the one corner at the far end of its base.
TEST(SeenFacets, TheBaseOfStairsIsDivided) {
  const Counts counts = divided({{0, 0, 0},
                                 {60, 0, 0},
                                 {60, 20, 0},
                                 {45, 20, 0},
                                 {45, 15, 0},
                                 {30, 15, 0},
                                 {30, 10, 0},
                                 {15, 10, 0},
                                 {15, 5, 0},
                                 {0, 5, 0}});
  EXPECT_GE(counts[0], 2);
  EXPECT_LE(counts[0], 4);
  EXPECT_EQ(Counts(counts.begin() + 1, counts.end()), Counts(9, 1));
}

TEST(SeenFacets, SoIsASideBesideASlot) {
  const Counts counts =
      divided({{0, 0, 0}, {30, 0, 0}, {30, 4, 0}, {16, 4, 0}, {16, 1, 0}, {14, 1, 0}, {14, 4, 0}, {0, 4, 0}});
  EXPECT_EQ(counts, (Counts{2, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(SeenFacets, ASlotThatEndsFarAwayIsLeft) {
  const Counts counts =
      divided({{0, 0, 0}, {30, 0, 0}, {30, 12, 0}, {16, 12, 0}, {16, 10, 0}, {14, 10, 0}, {14, 12, 0}, {0, 12, 0}});
  EXPECT_EQ(counts, Counts(8, 1));
}

// A slot with a vertex in the middle of one side: it is neither seen from across the slot, nor from behind that.
TEST(SeenFacets, WhatIsNotAcrossTheFaceIsNotSeen) {
  const Counts counts = divided({{0, 0, 0},
                                 {60, 0, 0},
                                 {60, 10, 0},
                                 {8, 10, 0},
                                 {8, 10.5, 0},
                                 {30, 10.5, 0},
                                 {60, 10.5, 0},
                                 {60, 30, 0},
                                 {0, 30, 0}});
  EXPECT_EQ(counts, Counts(9, 1));
}

// Nodes count as vertices do; as long facets as theirs are no worse for them.
TEST(SeenFacets, NodesOfShorterFacetsCount) {
  const Model strip = fake::polygon({{0, 0, 0}, {30, 0, 0}, {30, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(divided(strip, {1, 1, 2, 1}), (Counts{2, 1, 2, 1}));
  EXPECT_EQ(divided(strip, {2, 1, 2, 1}), (Counts{2, 1, 2, 1}));
}

TEST(SeenFacets, EdgesOfManyIntervalsAreLeft) {
  const Model strip = fake::polygon({{0, 0, 0}, {30, 0, 0}, {30, 1, 0}, {0, 1, 0}});
  EXPECT_EQ(divided(strip, {5, 1, 8, 1}), (Counts{5, 1, 8, 1}));
}

}  // namespace
}  // namespace paver
