// Numbers that belong together.
#pragma once

#include <algorithm>
#include <map>
#include <utility>
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
  /// Each with its numbers rising, by their first ones.
  std::vector<std::vector<int>> sets() {
    std::map<int, std::vector<int>> of_least;
    for (int i = 0; i < static_cast<int>(parent_.size()); ++i) of_least[find(i)].push_back(i);
    std::vector<std::vector<int>> list;
    for (auto& [least, set] : of_least) list.push_back(std::move(set));
    return list;
  }

 private:
  int& at(int i) { return parent_[i]; }
  std::vector<int> parent_;
};

}  // namespace paver
