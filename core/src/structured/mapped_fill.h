// What a region of a structured layout is filled with: places between those of a smoothed coarse grid.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "charts/chart.h"
#include "structured/grid_places.h"

namespace paver {

/// A block whose coarse nodes are placed.
struct MappedBlock {
  std::shared_ptr<const Chart> chart;
  GridPlaces coarse;              ///< chart points of the coarse nodes
  std::array<int, 2> fine{1, 1};  ///< quads either way
  bool is_clockwise = false;      ///< its quads (i, j), (i + 1, j), (i + 1, j + 1) in the chart

  /// Chart point of a fine node.
  Vec2 place(int i, int j) const;
};

/// The fine nodes first[0] to last[0] by first[1] to last[1] of a block.
struct MappedFill {
  std::shared_ptr<const MappedBlock> block;
  std::array<int, 2> first{}, last{};

  int columns() const { return last[0] - first[0]; }
  int rows() const { return last[1] - first[1]; }
  long quads() const { return static_cast<long>(columns()) * rows(); }
  /// The nodes on its outline, (i, j) of the block, counter-clockwise in the chart.
  std::vector<std::array<int, 2>> outline() const;
};

/// The block in rectangles of about `quads`.
std::vector<MappedFill> divided(const std::shared_ptr<const MappedBlock>& block, double quads);

}  // namespace paver
