// The nodes and quads of a structured layout, to be smoothed as if there were no blocks.
#pragma once

#include <functional>
#include <vector>

#include "structured/block_layout.h"
#include "structured/grid_smoothing.h"
#include "structured/mapped_fill.h"

namespace paver {

/// References to surface and sizes are kept.
class BlockGrid {
 public:
  /// Chart point at (s, t) of a block, each from 0 to 1.
  using Places = std::function<Vec2(std::size_t block, double s, double t)>;

  /// `final`: the counts that the layout stands for; its lengths are to suit them.
  BlockGrid(BlockLayout layout, const BlockLayout& final, const Surface& surface, const FaceSize& size,
            const Places& places);

  const BlockLayout& layout() const { return layout_; }
  GluedGrid& grid() { return grid_; }
  const GluedGrid& grid() const { return grid_; }
  int node(std::size_t block, int i, int j) const { return numbers_.node(block, i, j); }
  void place(int node, Vec2 p) { grid_.place(node, p, surface_, size_); }

  /// Chart points of a block's nodes, in the block's own chart.
  GridPlaces places(std::size_t block) const;
  /// Whether (i, j), (i + 1, j), (i + 1, j + 1) turn right in its chart.
  bool is_clockwise(std::size_t block) const { return is_clockwise_[block] != 0; }

 private:
  void add_quads(std::size_t block, const Block& final);

  BlockLayout layout_;
  BlockNumbers numbers_;
  const Surface& surface_;
  const FaceSize& size_;
  std::vector<char> is_clockwise_;  // per block
  GluedGrid grid_;                  // one chart per block, a node in the first that has it
};

struct Smoothing {
  int first_sweeps = 150;  ///< on the coarsest grid: long waves settle
  int least_sweeps = 2;    ///< on finer ones: they start smooth
  long coarsest_quads = 600;
};

/// A grid of a layout that stands for `final`, smoothed on coarser ones first. `settle`, if any, is called for every
/// grid before it is smoothed.
BlockGrid smoothed_grid(const BlockLayout& layout, const BlockLayout& final, const Surface& surface,
                        const FaceSize& size, const BlockGrid::Places& places, const Smoothing& smoothing,
                        const std::function<void(BlockGrid&)>& settle, const Progress& progress);

}  // namespace paver
