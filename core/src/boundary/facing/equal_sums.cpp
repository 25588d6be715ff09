#include "boundary/facing/equal_sums.h"

#include <algorithm>
#include <utility>

#include "base/union_find.h"

namespace paver {
namespace {

long sum(const std::vector<int>& side, const TiedCounts& tied) {
  long total = 0;
  for (int e : side) total += tied.groups[tied.group[e]].count;
  return total;
}

bool is_equal(const OppositeSides& pair, const TiedCounts& tied) {
  return sum(pair.first, tied) == sum(pair.second, tied);
}

class Restoring {
 public:
  Restoring(const std::vector<OppositeSides>& pairs, const TiedCounts& before, TiedCounts& tied)
      : before_(before), tied_(tied), of_group_(tied.groups.size()) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (!is_equal(pairs[i], before)) continue;
      pairs_.push_back({&pairs[i], before.is_thin[i] != 0});
      for (int e : pairs[i].edges()) of_group_[tied.group[e]].push_back(pairs_.back());
    }
  }

  void run() {
    // Every change leaves fewer unequal pairs, of thin faces first.
    while (std::ranges::count_if(pairs_, [&](const Pair& pair) { return restore(*pair.sides); }) > 0) {
    }
  }

 private:
  struct Pair {
    const OppositeSides* sides;
    bool is_thin;  // of a thin face
  };

  bool restore(const OppositeSides& pair) {
    if (is_equal(pair, tied_)) return false;
    return std::ranges::any_of(pair.edges(), [&](int e) { return turn_back(tied_.group[e]); });
  }

  /// Whether the group's count, changed the other way, leaves fewer unequal pairs, of thin faces first.
  bool turn_back(int group) {
    EdgeCount& now = tied_.groups[group];
    const int other = 2 * before_.groups[group].count - now.count;
    if (other == now.count || other < std::max(now.minimum, 1)) return false;
    const auto unequal = [&] {
      int thin = 0, all = 0;
      for (const Pair& pair : of_group_[group])
        if (!is_equal(*pair.sides, tied_)) ++all, thin += pair.is_thin ? 1 : 0;
      return std::pair(thin, all);
    };
    const auto least = unequal();
    const int kept = now.count;
    now.count = other;
    if (unequal() < least) return true;
    now.count = kept;
    return false;
  }

  const TiedCounts& before_;
  TiedCounts& tied_;
  std::vector<Pair> pairs_;                  // equal before
  std::vector<std::vector<Pair>> of_group_;  // of those, by group
};

}  // namespace

void restore_equal_sums(const std::vector<OppositeSides>& pairs, const TiedCounts& before, TiedCounts& tied) {
  Restoring(pairs, before, tied).run();
}

std::vector<std::vector<int>> edges_together(const std::vector<OppositeSides>& pairs, const TiedCounts& tied) {
  UnionFind together(tied.group.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (tied.is_thin[i] == 0 || !is_equal(pairs[i], tied)) continue;
    const std::vector<int> edges = pairs[i].edges();
    for (int e : edges) together.merge(edges[0], e);
  }
  std::vector<std::vector<int>> sets = together.sets();
  std::erase_if(sets, [](const std::vector<int>& set) { return set.size() < 2; });
  return sets;
}

}  // namespace paver
