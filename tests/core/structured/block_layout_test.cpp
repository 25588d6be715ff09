// Numbers of the nodes of blocks that share sides, and the fills of parts of a block.
#include "structured/block_layout.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "structured/closed_layout.h"
#include "structured/mapped_fill.h"

namespace paver {
namespace {

/// A cube of 2 x 3 x 4 quads, its sides the way they come, some turned over.
BlockLayout cube() {
  BlockLayout layout;
  for (const auto& [corner, count] :
       std::vector<std::pair<std::array<int, 4>, std::array<int, 2>>>{{{0, 1, 2, 3}, {2, 3}},
                                                                      {{4, 5, 6, 7}, {2, 3}},
                                                                      {{0, 1, 5, 4}, {2, 4}},
                                                                      {{2, 6, 5, 1}, {4, 3}},
                                                                      {{6, 2, 3, 7}, {4, 2}},
                                                                      {{3, 0, 4, 7}, {3, 4}}})
    layout.blocks.push_back({corner, count, nullptr, {}});
  return layout;
}

TEST(BlockNumbers, HaveNoGapsAndOneNumberForWhatBlocksShare) {
  const BlockLayout layout = cube();
  const BlockNumbers numbers(layout);
  EXPECT_EQ(numbers.size(), 3 * 4 * 5 - 1 * 2 * 3);  // of the solid grid, without those inside
  std::map<int, int> uses;
  std::map<std::pair<int, int>, int> sides;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b) {
    const auto [m, n] = layout.blocks[b].count;
    EXPECT_EQ(numbers.node(b, 0, 0), layout.blocks[b].corner[0]);
    EXPECT_EQ(numbers.node(b, m, n), layout.blocks[b].corner[2]);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= m; ++i) {
        ++uses[numbers.node(b, i, j)];
        if (i < m) ++sides[std::minmax(numbers.node(b, i, j), numbers.node(b, i + 1, j))];
        if (j < n) ++sides[std::minmax(numbers.node(b, i, j), numbers.node(b, i, j + 1))];
      }
  }
  EXPECT_EQ(uses.size(), static_cast<std::size_t>(numbers.size()));
  EXPECT_EQ(uses.begin()->first, 0);
  EXPECT_EQ(uses.rbegin()->first, numbers.size() - 1);
  for (int corner = 0; corner < 8; ++corner) EXPECT_EQ(uses[corner], 3);
  EXPECT_EQ(sides.size(), 2u * static_cast<std::size_t>(layout.quads())) << "of a closed grid of quads";
}

TEST(BlockLayout, KeepsCommonCountsEqualWhenScaled) {
  BlockLayout layout = cube();
  const BlockLayout finer = layout.scaled(7.3);
  EXPECT_EQ(BlockNumbers(finer).size(), finer.quads() + 2);
  EXPECT_EQ(layout.scaled(1e-3).quads(), 6);
  EXPECT_EQ(layout.limited(1000).quads(), layout.quads());
  EXPECT_NEAR(static_cast<double>(finer.limited(1000).quads()), 1000, 150);
}

TEST(NearestImage, MovesByWholePeriodsOnly) {
  EXPECT_EQ(nearest_image({7, 7}, {1, 100}, {2, 0}), (Vec2{1, 7}));
  EXPECT_EQ(nearest_image({-0.75, 3}, {1, 1}, {2, 1}), (Vec2{1.25, 1}));
}

// Coarse places of a smooth map: fine ones lie on it, coarse ones stay.
TEST(MappedFill, PartsCoverTheBlockAndAgreeOnTheirPlaces) {
  auto map = [](double s, double t) { return Vec2{2 * s + 0.1 * t * t, t + 0.05 * s * s * s}; };
  auto block = std::make_shared<MappedBlock>();
  block->coarse = {5, 4, {}};
  block->fine = {40, 30};
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 5; ++i) block->coarse.at.push_back(map(i / 5.0, j / 4.0));
  EXPECT_EQ(block->place(16, 15), block->coarse(2, 2));
  std::set<std::array<int, 2>> on_outlines;
  long quads = 0;
  for (const MappedFill& fill : divided(block, 150)) {
    quads += fill.quads();
    const auto outline = fill.outline();
    EXPECT_EQ(outline.size(), 2u * static_cast<std::size_t>(fill.columns() + fill.rows()));
    on_outlines.insert(outline.begin(), outline.end());
    double area = 0;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const auto [i, j] = outline[k];
      const auto [a, b] = outline[(k + 1) % outline.size()];
      area += cross(block->place(i, j), block->place(a, b));
      EXPECT_NEAR(norm(block->place(i, j) - map(i / 40.0, j / 30.0)), 0, 1e-12);
    }
    EXPECT_GT(area, 0);
  }
  EXPECT_EQ(quads, 40 * 30);
  EXPECT_TRUE(on_outlines.contains({0, 0}) && on_outlines.contains({40, 30}));
}

TEST(MappedFill, ItsOutlineTurnsLeftWhereTheBlockIsTurnedOver) {
  auto block = std::make_shared<MappedBlock>();
  block->fine = {2, 1};
  block->is_clockwise = true;
  MappedFill fill{block, {0, 0}, {2, 1}};
  const std::vector<std::array<int, 2>> wanted{{0, 1}, {1, 1}, {2, 1}, {2, 0}, {1, 0}, {0, 0}};
  EXPECT_EQ(fill.outline(), wanted);
}

}  // namespace
}  // namespace paver
