// Numbers that belong together.
#pragma once

#include <algorithm>
#include <vector>

namespace paver {

/// Disjoint sets of the numbers from 0; the least of a set stands for it.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count = 0) {
    while (parent_.size() < count) add();
  }
  /// A further number, by itself.
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int find(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void merge(int a, int b) {
    a = find(a);
    b = find(b);
    at(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace paver
