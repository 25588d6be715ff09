#include "boundary/facing/few_sides.h"

#include <algorithm>
#include <optional>

#include "boundary/facing/sides_of_loops.h"

namespace paver {
namespace {

constexpr double shortest_divided = 0.7;  // target lengths

/// All of a face's edges but those of its longest side, where each of them is a side of one interval; else none.
std::vector<int> single_sides(const Sides& sides, const std::vector<EdgeCount>& counts) {
  auto intervals = [&](const std::vector<int>& side) {
    int sum = 0;
    for (int e : side) sum += counts[e].count;
    return sum;
  };
  const auto longest = std::ranges::max_element(sides, {}, intervals);
  if (intervals(*longest) < 2) return {};
  std::vector<int> single;
  for (auto side = sides.begin(); side != sides.end(); ++side) {
    if (side == longest) continue;
    if (intervals(*side) != 1) return {};
    single.push_back(*std::ranges::find_if(*side, [&](int e) { return counts[e].count == 1; }));
  }
  return single;
}

}  // namespace

void divide_few_sides(const Model& model, const std::vector<std::vector<Loop>>& loops, std::vector<EdgeCount>& counts) {
  for (std::size_t f = 0; f < loops.size(); ++f) {
    if (loops[f].size() != 1) continue;
    const Loop& loop = loops[f][0];
    const std::optional<Sides> sides = sides_of(loop, angles_of(model, model.faces[f], loop), false);
    if (!sides || sides->size() < 2 || sides->size() > 3) continue;
    const std::vector<int> single = single_sides(*sides, counts);
    if (std::ranges::any_of(single, [&](int e) { return counts[e].wish <= shortest_divided; })) continue;
    for (int e : single) want_two(counts[e]);
  }
}

}  // namespace paver
