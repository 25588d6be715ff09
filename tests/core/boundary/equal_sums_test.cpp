// Sums of opposite sides that parity has made unequal.
#include "boundary/facing/equal_sums.h"

#include <gtest/gtest.h>

#include <utility>

namespace paver {
namespace {

/// Each edge a group of its own.
TiedCounts counts_of(const std::vector<int>& counts, std::vector<char> is_thin) {
  TiedCounts tied;
  tied.is_thin = std::move(is_thin);
  for (int count : counts) {
    tied.group.push_back(static_cast<int>(tied.group.size()));
    tied.groups.push_back({1.0 * count, 2, count});
  }
  return tied;
}

std::vector<int> restored(const std::vector<OppositeSides>& pairs, const std::vector<int>& before,
                          const std::vector<int>& changed, std::vector<char> is_thin = {}) {
  is_thin.resize(pairs.size());
  TiedCounts tied = counts_of(changed, is_thin);
  restore_equal_sums(pairs, counts_of(before, is_thin), tied);
  std::vector<int> counts;
  for (const EdgeCount& group : tied.groups) counts.push_back(group.count);
  return counts;
}

TEST(EqualSums, OneMoreAndOneLessBecomeAsMany) {
  EXPECT_EQ(restored({{0, {0}, {1, 2}}}, {5, 3, 2}, {4, 4, 2}), (std::vector<int>{6, 4, 2}));
}

TEST(EqualSums, CountsStayAboveTheirMinimum) {
  EXPECT_EQ(restored({{0, {0}, {1}}}, {2, 2}, {3, 1}), (std::vector<int>{3, 3})) << "1 is below";
  EXPECT_EQ(restored({{0, {0}, {1, 2}}}, {4, 2, 2}, {3, 3, 2}), (std::vector<int>{5, 3, 2}));
}

TEST(EqualSums, NoPairIsMadeUnequalForAnother) {
  const std::vector<OppositeSides> pairs = {{0, {0}, {1}}, {1, {0}, {2}}, {2, {1}, {3}}};
  EXPECT_EQ(restored(pairs, {5, 5, 5, 5}, {4, 6, 4, 6}), (std::vector<int>{4, 6, 4, 6}));
}

TEST(EqualSums, ThinFacesComeBeforeOthers) {
  const std::vector<OppositeSides> pairs = {{0, {1}, {0}}, {1, {1}, {2}}};
  EXPECT_EQ(restored(pairs, {5, 5, 5}, {6, 4, 4}, {1, 0}), (std::vector<int>{6, 6, 6}));
  EXPECT_EQ(restored(pairs, {5, 5, 5}, {6, 4, 4}), (std::vector<int>{4, 4, 4}));
}

TEST(EqualSums, EdgesAlongThinFacesOfEqualSumsBelongTogether) {
  const std::vector<OppositeSides> pairs = {{0, {0}, {1, 2}}, {1, {3}, {0}}, {2, {4}, {5}}, {3, {6}, {7}}};
  EXPECT_EQ(edges_together(pairs, counts_of({5, 3, 2, 5, 4, 5, 4, 4}, {1, 1, 1, 0})),
            (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
}

TEST(EqualSums, SidesThatWereUnequalStay) {
  EXPECT_EQ(restored({{0, {0}, {1}}}, {5, 7}, {4, 8}), (std::vector<int>{4, 8}));
}

}  // namespace
}  // namespace paver
