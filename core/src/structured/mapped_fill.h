// What a region of a structured layout is filled with: places between those of a smoothed coarse grid.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "charts/chart.h"

namespace paver {

/// Places of a grid's nodes, and between them as smooth as these: a finer grid that starts there needs little
/// smoothing.
struct GridPlaces {
  int m = 1, n = 1;      ///< quads either way
  std::vector<Vec2> at;  ///< row by row

  Vec2 operator()(int i, int j) const { return at[static_cast<std::size_t>(j) * (m + 1) + i]; }
  /// In cell (i, j), bilinear, s and t from 0 to 1.
  Vec2 in_cell(int i, int j, double s, double t) const {
    const GridPlaces& place = *this;
    return (1 - t) * ((1 - s) * place(i, j) + s * place(i + 1, j)) +
           t * ((1 - s) * place(i, j + 1) + s * place(i + 1, j + 1));
  }
  /// At s = 0..m, t = 0..n: by cubics through four by four places, linear where there are fewer than four either way.
  Vec2 between(double s, double t) const;
};

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
