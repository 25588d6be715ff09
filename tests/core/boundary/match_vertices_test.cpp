// Narrow faces with vertices on both sides: how many intervals their edges get.
#include <gtest/gtest.h>

#include "boundary/facing/raise_counts.h"
#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

using Counts = std::vector<int>;

/// Each edge with this wish.
Counts matched(const Model& model, const std::vector<double>& wishes) {
  std::vector<EdgeCount> counts;
  for (double wish : wishes) counts.push_back({wish, 1, std::max(1, static_cast<int>(wish + 0.5))});
  match_vertices(model, find_opposite_sides(model, {linked_loops(model, 0)}), counts);
  Counts result;
  for (const EdgeCount& count : counts) result.push_back(count.count);
  return result;
}

/// Edges 0 and 1 below, which meet at `below`, then one end; on top from 30 back edges 3 to 5, which meet at 10.5 and
/// 10; the other end.
Model end_of_board(double below, double height) {
  return fake::polygon(
      {{0, 0, 0}, {below, 0, 0}, {30, 0, 0}, {30, height, 0}, {10.5, height, 0}, {10, height, 0}, {0, height, 0}});
}

TEST(MatchVertices, EdgesGetANodeOppositeEachVertex) {
  EXPECT_EQ(matched(end_of_board(20, 0.1), std::vector<double>(7, 0.1)), (Counts{3, 1, 1, 2, 1, 1, 1}));
}

TEST(MatchVertices, PartsHaveWhatTheirLengthsAskFor) {
  EXPECT_EQ(matched(end_of_board(20, 0.1), {4, 2, 0.02, 4, 0.1, 2, 0.02}), (Counts{5, 2, 1, 4, 1, 2, 1}));
}

TEST(MatchVertices, VerticesThatFaceEachOtherNeedNone) {
  const Model model = fake::polygon({{0, 0, 0}, {10.05, 0, 0}, {30, 0, 0}, {30, 0.1, 0}, {10, 0.1, 0}, {0, 0.1, 0}});
  EXPECT_EQ(matched(model, std::vector<double>(6, 0.1)), (Counts{1, 1, 1, 1, 1, 1}));
}

TEST(MatchVertices, WideFacesAreLeftAlone) {
  EXPECT_EQ(matched(end_of_board(20, 10), {2, 1, 1, 2, 0.1, 1, 1}), (Counts{2, 1, 1, 2, 1, 1, 1}));
}

}  // namespace
}  // namespace paver
