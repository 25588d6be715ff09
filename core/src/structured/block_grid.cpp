// Blocks are interpolated one by one: what lies in two of them belongs to the first.
#include "structured/block_grid.h"

#include <algorithm>
#include <memory>

namespace paver {
namespace {

/// Between the nodes of a smoothed grid of the same blocks.
BlockGrid::Places between_nodes(const BlockGrid& coarse) {
  std::vector<GridPlaces> places;
  for (std::size_t b = 0; b < coarse.layout().blocks.size(); ++b) places.push_back(coarse.places(b));
  return [places = std::move(places)](std::size_t b, double s, double t) {
    return places[b].between(s * places[b].m, t * places[b].n);
  };
}

}  // namespace

BlockGrid::BlockGrid(BlockLayout layout, const BlockLayout& final, const Surface& surface, const FaceSize& size,
                     const Places& places)
    : layout_(std::move(layout)), numbers_(layout_), surface_(surface), size_(size) {
  RegionMesh& mesh = grid_.mesh;
  mesh.reserve(static_cast<std::size_t>(numbers_.size()));
  for (int v = 0; v < numbers_.size(); ++v) mesh.add_node({}, 0);
  grid_.chart.assign(mesh.p.size(), -1);
  for (std::size_t b = 0; b < layout_.blocks.size(); ++b) {
    const Block& block = layout_.blocks[b];
    const auto [m, n] = block.count;
    grid_.charts.push_back(block.chart);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= m; ++i) {
        const int v = node(b, i, j);
        if (grid_.chart[v] >= 0) continue;
        grid_.chart[v] = static_cast<int>(b);
        place(v, places(b, static_cast<double>(i) / m, static_cast<double>(j) / n));
      }
  }
  for (std::size_t b = 0; b < layout_.blocks.size(); ++b) add_quads(b, final.blocks[b]);
}

// Counter-clockwise in the block's chart, as most of them are where the grid starts.
void BlockGrid::add_quads(std::size_t b, const Block& final) {
  const auto [m, n] = layout_.blocks[b].count;
  const GridPlaces at = places(b);
  double area = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) area += cross(at(i + 1, j + 1) - at(i, j), at(i, j + 1) - at(i + 1, j));
  is_clockwise_.push_back(area < 0);
  const float along = static_cast<float>(final.count[0]) / static_cast<float>(m);
  const float up = static_cast<float>(final.count[1]) / static_cast<float>(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      Corners quad{node(b, i, j), node(b, i + 1, j), node(b, i + 1, j + 1), node(b, i, j + 1)};
      std::array<float, 4> wish{along, up, along, up};
      if (area < 0) std::swap(quad[1], quad[3]), wish = {up, along, up, along};
      grid_.mesh.add_element(quad);
      grid_.wishes.push_back(wish);
    }
}

GridPlaces BlockGrid::places(std::size_t b) const {
  const Block& block = layout_.blocks[b];
  const bool has_images = !(layout_.period == Vec2{});
  GridPlaces result{block.count[0], block.count[1], {}};
  for (int j = 0; j <= block.count[1]; ++j)
    for (int i = 0; i <= block.count[0]; ++i) {
      const int v = node(b, i, j);
      const auto chart = static_cast<std::size_t>(grid_.chart[v]);
      const bool is_own = chart == b || (!has_images && grid_.charts[chart] == block.chart);
      result.at.push_back(is_own ? grid_.mesh.p[v]
                                 : block.chart->to_chart(nearest_image(grid_.uv(v), block.middle, layout_.period)));
    }
  return result;
}

BlockGrid smoothed_grid(const BlockLayout& layout, const BlockLayout& final, const Surface& surface,
                        const FaceSize& size, const BlockGrid::Places& places, const Smoothing& smoothing,
                        const std::function<void(BlockGrid&)>& settle, const Progress& progress) {
  std::vector<BlockLayout> levels{layout};
  while (levels.back().quads() > smoothing.coarsest_quads) levels.push_back(levels.back().scaled(0.5));
  std::unique_ptr<BlockGrid> grid;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    auto finer = std::make_unique<BlockGrid>(*level, final, surface, size, grid ? between_nodes(*grid) : places);
    if (settle) settle(*finer);
    // More for small ones, where they cost little and spare the finer ones work.
    const int again = std::clamp(30000 / finer->grid().mesh.node_count(), smoothing.least_sweeps, 30);
    smooth_grid(finer->grid(), surface, size, grid ? again : smoothing.first_sweeps, progress);
    grid = std::move(finer);
  }
  return std::move(*grid);
}

}  // namespace paver
