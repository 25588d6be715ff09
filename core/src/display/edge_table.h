// Mesh edges numbered as they are met; for meshes of millions of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace paver {

/// A mesh edge: its ends, and one of its inner nodes because two curved edges may have the same ends.
struct EdgeKey {
  int low, high, inner;
  bool operator==(const EdgeKey&) const = default;
};

/// Ends `a`, `b`; `inner`: the order - 1 nodes between them.
inline EdgeKey edge_key(int a, int b, const int* inner, int order) {
  return {std::min(a, b), std::max(a, b), order > 1 ? std::min(inner[0], inner[order - 2]) : -1};
}

/// Open addressing with linear probing; never more than half full.
class EdgeTable {
 public:
  /// Room for so many edges; more may come.
  explicit EdgeTable(std::size_t expected) { resize(expected); }

  /// Number of the edge (0, 1, ... in the order of first calls), and whether this is the first call for it.
  std::pair<int, bool> number(const EdgeKey& key) {
    if (2 * (keys_.size() + 1) > slots_.size()) resize(2 * keys_.size() + 1);
    int& slot = slots_[place(key)];
    if (slot >= 0) return {slot, false};
    slot = static_cast<int>(keys_.size());
    keys_.push_back(key);
    return {slot, true};
  }

  /// -1: never numbered.
  int find(const EdgeKey& key) const { return slots_[place(key)]; }

 private:
  void resize(std::size_t expected) {
    std::size_t size = 16;
    while (size < 2 * expected + 2) size *= 2;
    slots_.assign(size, -1);
    for (std::size_t i = 0; i < keys_.size(); ++i) slots_[place(keys_[i])] = static_cast<int>(i);
  }

  /// The slot that holds the key, or the free one where it belongs.
  std::size_t place(const EdgeKey& key) const {
    std::uint64_t hash = static_cast<std::uint64_t>(key.low) * 0x9E3779B97F4A7C15u;
    hash = (hash ^ static_cast<std::uint64_t>(key.high) ^ static_cast<std::uint64_t>(key.inner + 1) << 32) *
           0xC2B2AE3D27D4EB4Fu;
    std::size_t mask = slots_.size() - 1, at = static_cast<std::size_t>(hash >> 20) & mask;
    while (slots_[at] >= 0 && !(keys_[slots_[at]] == key)) at = (at + 1) & mask;
    return at;
  }

  std::vector<EdgeKey> keys_;
  std::vector<int> slots_;  ///< a power of two of them: numbers of edges, or -1
};

}  // namespace paver
