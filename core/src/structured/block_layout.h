// A structured layout: a few coarse quads, its blocks, each divided m x n.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "charts/chart.h"

namespace paver {

struct Block {
  std::array<int, 4> corner{};     ///< of the layout, one after the other about the block
  std::array<int, 2> count{1, 1};  ///< quads from corner 0 to 1 and from 1 to 2
  std::shared_ptr<const Chart> chart;
  Vec2 middle;  ///< (u, v): tells images a period apart from each other
};

/// Blocks with two corners in common have the side between them in common, and its count.
struct BlockLayout {
  std::vector<Block> blocks;
  Vec2 period;  ///< of (u, v); 0 where there is none

  long quads() const;
  /// With about `factor` times as many quads each way.
  BlockLayout scaled(double factor) const;
  /// With about `most` quads where it has more.
  BlockLayout limited(long most) const;
};

/// Numbers of a layout's nodes, without gaps; nodes on common sides and corners have one.
class BlockNumbers {
 public:
  explicit BlockNumbers(const BlockLayout& layout);
  int size() const { return size_; }
  /// i = 0..m from corner 0 to corner 1, j = 0..n from there to corner 2.
  int node(std::size_t block, int i, int j) const;

 private:
  struct Side {
    int first = 0, count = 1;  // of its nodes between the corners
    bool is_reversed = false;
  };
  struct Numbered {
    std::array<int, 4> corner;
    std::array<int, 2> count;
    std::array<Side, 4> side;
    int first = 0;  // of the nodes inside
  };
  static int on_side(const Numbered& block, std::size_t side, int at);

  std::vector<Numbered> blocks_;
  int size_ = 0;
};

}  // namespace paver
