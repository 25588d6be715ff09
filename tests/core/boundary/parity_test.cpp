#include "boundary/parity.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

using Loops = std::vector<std::vector<int>>;

int odd_loops(const Loops& loops, const std::vector<EdgeCount>& counts) {
  int odd = 0;
  for (const std::vector<int>& loop : loops) {
    int total = 0;
    for (int edge : loop) total += counts[static_cast<std::size_t>(edge)].count;
    odd += total % 2;
  }
  return odd;
}

EdgeCount edge(double wish) { return {wish, 1, std::max(1, static_cast<int>(wish + 0.5))}; }

TEST(EvenOutLoops, TwoOddLoopsAreMendedByTheirCommonEdge) {
  Loops loops = {{0, 1, 2}, {0, 3, 4}};
  std::vector<EdgeCount> counts = {edge(9.4), edge(5), edge(5), edge(5), edge(5)};
  counts[1].wish = counts[2].wish = counts[3].wish = counts[4].wish = 5;
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(odd_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 10) << "9.4 was rounded down, so it goes up";
}

TEST(EvenOutLoops, AFreeEdgeTakesTheParityOfALoneLoop) {
  Loops loops = {{0, 1, 2}};
  std::vector<EdgeCount> counts = {edge(3), edge(20.4), edge(10)};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[1].count, 21) << "the least relative change";
  EXPECT_EQ(counts[0].count, 3);
}

TEST(EvenOutLoops, ParityTravelsThroughLoopsThatAreEven) {
  // A strip of four loops; edge i joins loop i to loop i + 1, nothing is free; the first and the last are odd.
  Loops loops = {{0}, {0, 1}, {1, 2}, {2}};
  std::vector<EdgeCount> counts = {edge(9), edge(9), edge(9)};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(odd_loops(loops, counts), 0);
}

TEST(EvenOutLoops, AnEdgeUsedTwiceByOneLoopHasNoEffectOnIt) {
  Loops loops = {{0, 0, 1}};
  std::vector<EdgeCount> counts = {edge(50), edge(3)};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 50);
  EXPECT_EQ(counts[1].count, 4);
}

TEST(EvenOutLoops, AnEntryThatStandsForOppositeSidesCarriesParityAcross) {
  // 0 stands for both ends of a strip of quads: one of them in loop 0, the other in loop 2, each also in loop 1.
  Loops loops = {{0, 1, 1}, {0, 0, 2, 2}, {0, 3, 3}};
  std::vector<EdgeCount> counts = {edge(5), edge(4), edge(4), edge(4)};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 6);
}

TEST(EvenOutLoops, TiedEdgesChangeOnlyWhenOthersWouldChangeMuchMore) {
  Loops loops = {{0, 1, 2}};
  std::vector<EdgeCount> counts = {{20.4, 1, 20}, {18.4, 1, 18}, {3, 1, 3}};
  counts[0].is_tied = true;
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 20);
  EXPECT_EQ(counts[1].count, 19);
}

TEST(EvenOutLoops, OneOddLoopWithoutPartnerStaysOdd) {
  Loops alone = {{0, 0, 0}, {1, 1}};
  std::vector<EdgeCount> locked = {{0.2, 1, 1}, edge(4)};
  EXPECT_EQ(even_out_loops(alone, locked), 1);
}

TEST(EvenOutLoops, CountsNeverFallBelowTheMinimum) {
  Loops loops = {{0}};
  std::vector<EdgeCount> counts = {{2.1, 3, 3}};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 4);
}

TEST(EvenOutLoops, ShortSingleIntervalsStayLocked) {
  Loops loops = {{0, 1, 2}};
  std::vector<EdgeCount> counts = {{0.3, 1, 1}, {0.3, 1, 1}, {0.3, 1, 1}};
  EXPECT_EQ(even_out_loops(loops, counts), 1);
  for (const EdgeCount& count : counts) EXPECT_EQ(count.count, 1);
}

TEST(EvenOutLoops, SingleIntervalsNearTheTargetLengthAreSplitWhenNothingElseHelps) {
  Loops loops = {{0, 1, 2}};
  std::vector<EdgeCount> counts = {{0.3, 1, 1}, {0.9, 1, 1}, {0.3, 1, 1}};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[1].count, 2);
}

TEST(EvenOutLoops, AnEdgeOfThreeLoopsIsTakenWhereItLeavesFewerOddOnes) {
  Loops loops = {{0, 1, 1}, {0, 2, 2}, {0, 3, 3}};
  std::vector<EdgeCount> counts = {edge(5), edge(4), edge(4), edge(4)};
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(counts[0].count, 6);
}

TEST(EvenOutLoops, ShortEdgesAreSplitOnlyOnDemand) {
  Loops loops = {{0, 1, 2}};
  std::vector<EdgeCount> counts = {edge(0.5), edge(0.4), edge(0.3)};
  EXPECT_EQ(even_out_loops(loops, counts), 1);
  EXPECT_EQ(even_out_loops(loops, counts, true), 0);
  EXPECT_EQ(odd_loops(loops, counts), 0);
}

TEST(EvenOutLoops, ALargeGridOfRandomCountsComesOutEven) {
  constexpr int n = 40;  // n x n cells; horizontal edges first
  Loops loops;
  auto horizontal = [](int i, int j) { return j * n + i; };
  auto upright = [](int i, int j) { return n * (n + 1) + j * (n + 1) + i; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      loops.push_back({horizontal(i, j), upright(i + 1, j), horizontal(i, j + 1), upright(i, j)});
    }
  }
  std::vector<EdgeCount> counts;
  unsigned state = 12345;
  for (int e = 0; e < 2 * n * (n + 1); ++e) {
    state = state * 1664525u + 1013904223u;
    counts.push_back(edge(2 + static_cast<double>(state >> 16) / 65536.0 * 12));
  }
  std::vector<EdgeCount> before = counts;
  EXPECT_EQ(even_out_loops(loops, counts), 0);
  EXPECT_EQ(odd_loops(loops, counts), 0);
  for (std::size_t e = 0; e < counts.size(); ++e) EXPECT_LE(std::abs(counts[e].count - before[e].count), 1);
}

}  // namespace
}  // namespace paver
