// Counts along chords that are made up: sides and what runs between them.
#include "multilevel/coarse/edge_counts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace paver {
namespace {

/// An outline (side 0) and a hole (side 1), each of coarse facets with so many fine ones. The hole's chords end on the
/// first facets of the outline; the others of the outline are joined two by two.
struct Ring {
  CoarseRegion coarse;
  CoarseNet net;
  std::vector<Chord> chords;

  Ring(const std::vector<int>& outline, const std::vector<int>& hole) {
    add_side(outline);
    add_side(hole);
    const int first = static_cast<int>(outline.size()), rest = first - static_cast<int>(hole.size());
    for (int i = 0; i < static_cast<int>(hole.size()); ++i) chords.push_back({{i, first + i}, {0, 1}});
    for (int i = 0; i + 1 < rest; i += 2)
      chords.push_back({{static_cast<int>(hole.size()) + i, static_cast<int>(hole.size()) + i + 1}, {0, 0}});
  }

  void add_side(const std::vector<int>& facets) {
    std::vector<int>& at = coarse.at.emplace_back(1, 0);
    for (int fine : facets) {
      CoarseEdge edge;
      edge.loop = static_cast<int>(coarse.at.size()) - 1;
      edge.facet = static_cast<int>(at.size()) - 1;
      net.edges.push_back(edge);
      at.push_back(at.back() + fine);
    }
    coarse.side_intervals.push_back(at.back());
  }

  /// Of each side, by the counts.
  std::vector<int> sums(const std::vector<int>& counts) const {
    std::vector<int> result(coarse.side_intervals.size(), 0);
    for (std::size_t e = 0; e < net.edges.size(); ++e) result[static_cast<std::size_t>(net.edges[e].loop)] += counts[e];
    return result;
  }
};

// All chords to the hole want two and more: one is taken off each, however often a path passes the cheapest.
TEST(EdgeCounts, AHoleThatIsDividedLessThanItsChordsWish) {
  for (int others : {4, 10, 30}) {
    std::vector<int> outline(static_cast<std::size_t>(6 + others), 3);
    Ring ring(outline, {1, 2, 1, 1, 2, 1});
    auto counts = choose_edge_counts(ring.coarse, ring.net, ring.chords, std::vector<double>(ring.net.edges.size(), 3));
    ASSERT_TRUE(counts) << others;
    EXPECT_EQ(ring.sums(*counts), ring.coarse.side_intervals);
    EXPECT_GE(*std::min_element(counts->begin(), counts->end()), 1);
  }
}

}  // namespace
}  // namespace paver
