// Numbers: corners, then the nodes between them side by side, then those inside, block by block.
#include "structured/block_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace paver {

long BlockLayout::quads() const {
  long sum = 0;
  for (const Block& block : blocks) sum += static_cast<long>(block.count[0]) * block.count[1];
  return sum;
}

BlockLayout BlockLayout::scaled(double factor) const {
  BlockLayout result = *this;
  for (Block& block : result.blocks)
    for (int& count : block.count) count = std::max(1, static_cast<int>(std::lround(factor * count)));
  return result;
}

BlockLayout BlockLayout::limited(long most) const {
  return quads() > most ? scaled(std::sqrt(static_cast<double>(most) / static_cast<double>(quads()))) : *this;
}

BlockNumbers::BlockNumbers(const BlockLayout& layout) {
  for (const Block& block : layout.blocks)
    for (int corner : block.corner) size_ = std::max(size_, corner + 1);
  std::map<std::pair<int, int>, int> known;  // by the ends of a side: its first node
  for (const Block& block : layout.blocks) {
    Numbered& numbered = blocks_.emplace_back();
    numbered.corner = block.corner;
    numbered.count = block.count;
    for (std::size_t k = 0; k < 4; ++k) {
      const int from = block.corner[k], to = block.corner[(k + 1) % 4], count = block.count[k % 2];
      auto [side, is_new] = known.insert({std::minmax(from, to), size_});
      if (is_new) size_ += count - 1;
      numbered.side[k] = {side->second, count, from > to};
    }
  }
  for (Numbered& block : blocks_) {
    block.first = size_;
    size_ += (block.count[0] - 1) * (block.count[1] - 1);
  }
}

int BlockNumbers::on_side(const Numbered& block, std::size_t side, int at) {
  if (at == 0) return block.corner[side];
  const Side& s = block.side[side];
  return s.first + (s.is_reversed ? s.count - at : at) - 1;
}

int BlockNumbers::node(std::size_t index, int i, int j) const {
  const Numbered& block = blocks_[index];
  const auto [m, n] = block.count;
  if (j == 0 && i < m) return on_side(block, 0, i);
  if (i == m && j < n) return on_side(block, 1, j);
  if (j == n && i > 0) return on_side(block, 2, m - i);
  if (i == 0) return on_side(block, 3, n - j);
  return block.first + (j - 1) * (m - 1) + i - 1;
}

}  // namespace paver
