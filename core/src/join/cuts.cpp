// Of several regions' places for one side the first region's is taken.
#include "join/cuts.h"

#include <algorithm>
#include <tuple>

namespace paver {
namespace {

std::tuple<int, int, int> key(const CutSide& side) { return {side.face, side.a, side.b}; }

void add_loop(const Region& region, const std::vector<LoopNode>& loop, std::vector<CutSide>& sides) {
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const LoopNode *a = &loop[i], *b = &loop[(i + 1) % n];
    if (a->edge >= 0) continue;
    if (a->global > b->global) std::swap(a, b);
    sides.push_back({region.face, a->global, b->global, &region, a->p, b->p});
  }
}

}  // namespace

Cuts::Cuts(const std::vector<Region>& regions, std::vector<CutSide> outlines) : sides_(std::move(outlines)) {
  for (const Region& region : regions)
    for (const auto& loop : region.loops) add_loop(region, loop, sides_);
  std::ranges::stable_sort(sides_, {}, key);
  auto is_same = [](const CutSide& one, const CutSide& other) { return key(one) == key(other); };
  sides_.erase(std::unique(sides_.begin(), sides_.end(), is_same), sides_.end());
}

int Cuts::find(int face, int a, int b) const {
  const std::tuple wanted{face, std::min(a, b), std::max(a, b)};
  const auto at = std::ranges::lower_bound(sides_, wanted, {}, key);
  return at != sides_.end() && key(*at) == wanted ? static_cast<int>(at - sides_.begin()) : -1;
}

}  // namespace paver
