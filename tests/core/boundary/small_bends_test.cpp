#include "boundary/small_bends.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

/// Rows at these places; between the two of each pair the curve turns by `turn`.
std::vector<TurnedTo> curve(double length, double turn, const std::vector<std::array<double, 2>>& bends) {
  std::vector<TurnedTo> rows{{0, 0}};
  for (auto [from, to] : bends)
    for (int i = 0; i <= 8; ++i) {
      const double before = i == 0 ? rows.back().turn : rows[rows.size() - 1].turn + turn / 8;
      rows.push_back({from + (to - from) * i / 8, before});
    }
  rows.push_back({length, rows.back().turn});
  return rows;
}

std::vector<SmallBend> bends_of(const std::vector<TurnedTo>& rows) {
  return find_small_bends(rows, std::vector<double>(rows.size(), 1), 0.8);
}

TEST(FindSmallBends, FindsEachAndWhereItIs) {
  const std::vector<TurnedTo> rows = curve(20, 1.5, {{5, 5.5}, {12, 12.2}});
  const std::vector<SmallBend> bends = bends_of(rows);
  ASSERT_EQ(bends.size(), 2U);
  for (auto [bend, from, to] : {std::tuple{bends[0], 5.0, 5.5}, std::tuple{bends[1], 12.0, 12.2}}) {
    EXPECT_NEAR(rows[static_cast<std::size_t>(bend.first)].s, from, 1e-9);
    EXPECT_GE(rows[static_cast<std::size_t>(bend.last)].s, to - 1e-9);
    EXPECT_LE(rows[static_cast<std::size_t>(bend.last)].s, from + 1);
  }
}

TEST(FindSmallBends, LeavesWhatTurnsLittleOrFoldsBackOrIsLong) {
  EXPECT_TRUE(bends_of(curve(20, 0.7, {{5, 5.5}})).empty());
  EXPECT_TRUE(bends_of(curve(20, 3.1, {{5, 5.5}})).empty());
  EXPECT_TRUE(bends_of(curve(20, 1.5, {{5, 8}})).empty());
}

TEST(FindSmallBends, FindsHooksAtEndsThatFoldBack) {
  EXPECT_EQ(bends_of(curve(20, 4, {{0.2, 0.5}, {19.4, 19.7}})).size(), 2U);
  EXPECT_TRUE(bends_of(curve(20, 4, {{0.8, 1.1}, {18.9, 19.2}})).empty());
}

TEST(FindSmallBends, LeavesWhatGoesOnTurning) {
  EXPECT_EQ(bends_of(curve(20, 1.5, {{5, 5.5}, {7, 7.5}})).size(), 2U);
  EXPECT_TRUE(bends_of(curve(20, 1.5, {{5, 5.5}, {6, 6.5}})).empty());
  EXPECT_TRUE(bends_of(curve(20, 1.5, {{5, 5.5}, {6, 6.5}, {7, 7.5}})).empty());
}

}  // namespace
}  // namespace paver
