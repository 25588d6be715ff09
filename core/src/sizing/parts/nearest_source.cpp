// Boxes are halved at the middle of their longest side's order; a search enters a box only while its least length at
// its nearest point is below the best so far.
#include "sizing/parts/nearest_source.h"

#include <algorithm>

#include "base/segment.h"

namespace paver {
namespace {

constexpr int leaf_sources = 4;

double coordinate(Vec3 x, int axis) { return axis == 0 ? x.x : axis == 1 ? x.y : x.z; }

double outside(double value, double lo, double hi) { return std::max({lo - value, value - hi, 0.0}); }

}  // namespace

NearestSource::NearestSource(std::vector<SizeSource> sources, double gradation)
    : sources_(std::move(sources)), gradation_(gradation) {
  if (!sources_.empty()) add_branch(0, static_cast<int>(sources_.size()));
}

int NearestSource::add_branch(int first, int count) {
  const auto begin = sources_.begin() + first, end = begin + count;
  Branch branch{{}, begin->h, first, count, -1};
  for (auto source = begin; source != end; ++source) {
    for (Vec3 x : {source->a, source->b}) branch.box.add(x);
    branch.h = std::min(branch.h, source->h);
  }
  const int index = static_cast<int>(branches_.size());
  branches_.push_back(branch);
  if (count <= leaf_sources) return index;
  Vec3 size = branch.box.high - branch.box.low;
  int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const SizeSource& p, const SizeSource& q) {
    return coordinate(p.a, axis) + coordinate(p.b, axis) < coordinate(q.a, axis) + coordinate(q.b, axis);
  });
  add_branch(first, half);
  int second = add_branch(first + half, count - half);
  branches_[index].count = 0;
  branches_[index].second_child = second;
  return index;
}

double NearestSource::bound(const Branch& branch, Vec3 x) const {
  const auto& [low, high] = branch.box;
  Vec3 away{outside(x.x, low.x, high.x), outside(x.y, low.y, high.y), outside(x.z, low.z, high.z)};
  return branch.h + gradation_ * norm(away);
}

double NearestSource::search(Vec3 x, double most, int left_out) const {
  double best = most;
  if (branches_.empty()) return best;
  std::array<int, 64> open;  // depth of a tree over an int's count of sources, two boxes a level
  int count = 0;
  open[count++] = 0;
  while (count > 0) {
    int index = open[--count];
    const Branch& branch = branches_[index];
    if (bound(branch, x) >= best) continue;
    for (int i = branch.first; i < branch.first + branch.count; ++i) {
      const SizeSource& source = sources_[i];
      if (source.group == left_out) continue;
      best = std::min(best, source.h + gradation_ * distance_to_segment(x, source.a, source.b));
    }
    if (branch.count > 0) continue;
    int near = index + 1, far = branch.second_child;
    if (bound(branches_[far], x) < bound(branches_[near], x)) std::swap(near, far);
    open[count++] = far;
    open[count++] = near;
  }
  return best;
}

}  // namespace paver
