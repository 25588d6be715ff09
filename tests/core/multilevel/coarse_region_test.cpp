// Coarse loops, chords and counts on small regions.
#include "multilevel/coarse/coarse_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>

#include "multilevel/coarse/coarse_net.h"
#include "multilevel/coarse/edge_counts.h"
#include "paving/pave_region.h"
#include "support/planar_region.h"

namespace paver {
namespace {

using test::circle;
using test::divided;
using test::planar_region;
using test::reversed;

using Loops = std::vector<std::vector<Vec2>>;

TEST(Coarsen, KeepsCornersAndSpreadsTheRest) {
  Region region = planar_region({divided({{0, 0}, {10, 0}, {10, 4}, {0, 4}}, 0.25)}, 0.25);
  auto coarse = coarsen(region, 4);
  ASSERT_TRUE(coarse);
  EXPECT_EQ(coarse->region.h, 1);
  ASSERT_EQ(coarse->side_intervals, (std::vector<int>{40, 16, 40, 16}));
  EXPECT_EQ(coarse->region.loops[0].size(), 28u);
  for (std::size_t i = 0; i < 28; ++i) EXPECT_EQ(coarse->fine_facets(0, i), 4) << i;
  for (int corner : {0, 40, 56, 96}) {
    auto is_kept = [&](const LoopNode& node) { return node.global == region.loops[0][corner].global; };
    EXPECT_EQ(std::count_if(coarse->region.loops[0].begin(), coarse->region.loops[0].end(), is_kept), 1) << corner;
  }
}

TEST(Coarsen, LoopsAreEvenAndFollowTheirTurn) {
  for (int n : {40, 41, 50, 63}) {
    auto coarse = coarsen(planar_region({circle({0, 0}, 10, n)}, 20 * M_PI / n), 8);
    ASSERT_TRUE(coarse) << n;
    EXPECT_EQ(coarse->region.loops[0].size() % 2, 0u) << n;
    EXPECT_GE(coarse->region.loops[0].size(), 6u) << n;
    EXPECT_EQ(coarse->at[0].back() - coarse->at[0].front(), n);
  }
  EXPECT_FALSE(coarsen(planar_region({{{0, 0}, {1, 0}, {0, 1}}}, 1), 4)) << "three facets cannot be four";
}

/// Per side the sum of the counts of its edges.
std::vector<int> side_sums(const CoarseRegion& coarse, const CoarseNet& net, const std::vector<int>& counts) {
  std::vector<int> sums(coarse.side_intervals.size(), 0);
  for (std::size_t e = 0; e < counts.size(); ++e)
    if (net.edges[e].loop >= 0) sums[coarse.side[net.edges[e].loop][net.edges[e].facet]] += counts[e];
  return sums;
}

void expect_counts(const Loops& loops, double h, int ratio, int most_unequal) {
  Region region = planar_region(loops, h);
  auto coarse = coarsen(region, ratio);
  ASSERT_TRUE(coarse);
  RegionMesh mesh = pave_region(coarse->region, Progress()).mesh;
  auto net = build_net(*coarse, mesh);
  ASSERT_TRUE(net);
  std::vector<Chord> chords = find_chords(*coarse, mesh, *net);
  std::vector<int> uses(net->edges.size(), 0);
  for (const Chord& chord : chords)
    for (int e : chord.edges) ++uses[e];
  EXPECT_EQ(uses, std::vector<int>(uses.size(), 1)) << "every edge in one chord";
  auto counts = choose_edge_counts(*coarse, *net, chords, std::vector<double>(uses.size(), ratio));
  ASSERT_TRUE(counts);
  EXPECT_EQ(side_sums(*coarse, *net, *counts), coarse->side_intervals);
  int unequal = 0;
  for (std::size_t q = 0; q < mesh.elements.size(); ++q) {
    if (!mesh.elements[q].is_alive() || mesh.elements[q].corners() == 3) continue;
    const auto& e = net->of_element[q];
    unequal += (*counts)[e[0]] != (*counts)[e[2]] || (*counts)[e[1]] != (*counts)[e[3]];
  }
  EXPECT_LE(unequal, most_unequal);
}

TEST(EdgeCounts, SidesThatAgreeNeedNoChange) {
  expect_counts({divided({{0, 0}, {41, 0}, {41, 23}, {0, 23}}, 1)}, 1, 5, 0);
  expect_counts({divided({{0, 0}, {60, 0}, {60, 60}, {0, 60}}, 1), reversed(circle({30, 30}, 12, 76))}, 1, 6, 0);
}

TEST(EdgeCounts, WhereSidesDisagreeSomeChordChanges) {
  // Opposite sides of 40 and 42.
  std::vector<Vec2> loop;
  for (int i = 0; i < 40; ++i) loop.push_back({static_cast<double>(i), 0});
  for (int i = 0; i < 20; ++i) loop.push_back({40, static_cast<double>(i)});
  for (int i = 0; i < 42; ++i) loop.push_back({40 - 40.0 * i / 42, 20});
  for (int i = 0; i < 20; ++i) loop.push_back({0, 20.0 - i});
  expect_counts({loop}, 1, 5, 2);
  loop.insert(loop.begin() + 1, {0.5, 0});  // odd
  expect_counts({loop}, 1, 5, 2);
}

}  // namespace
}  // namespace paver
