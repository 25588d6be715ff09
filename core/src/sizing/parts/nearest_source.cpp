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
  if (!sources_.empty()) add_box(0, static_cast<int>(sources_.size()));
}

int NearestSource::add_box(int first, int count) {
  const auto begin = sources_.begin() + first, end = begin + count;
  Box box{begin->a, begin->a, begin->h, first, count, -1};
  for (auto source = begin; source != end; ++source) {
    for (Vec3 x : {source->a, source->b}) {
      box.lo = {std::min(box.lo.x, x.x), std::min(box.lo.y, x.y), std::min(box.lo.z, x.z)};
      box.hi = {std::max(box.hi.x, x.x), std::max(box.hi.y, x.y), std::max(box.hi.z, x.z)};
    }
    box.h = std::min(box.h, source->h);
  }
  const int index = static_cast<int>(boxes_.size());
  boxes_.push_back(box);
  if (count <= leaf_sources) return index;
  Vec3 size = box.hi - box.lo;
  int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  int half = count / 2;
  std::nth_element(begin, begin + half, end, [axis](const SizeSource& p, const SizeSource& q) {
    return coordinate(p.a, axis) + coordinate(p.b, axis) < coordinate(q.a, axis) + coordinate(q.b, axis);
  });
  add_box(first, half);
  int second = add_box(first + half, count - half);
  boxes_[static_cast<std::size_t>(index)].count = 0;
  boxes_[static_cast<std::size_t>(index)].second_child = second;
  return index;
}

double NearestSource::bound(const Box& box, Vec3 x) const {
  Vec3 away{outside(x.x, box.lo.x, box.hi.x), outside(x.y, box.lo.y, box.hi.y), outside(x.z, box.lo.z, box.hi.z)};
  return box.h + gradation_ * norm(away);
}

double NearestSource::least(Vec3 x, double most) const {
  double best = most;
  if (boxes_.empty()) return best;
  std::array<int, 64> open;  // depth of a tree over an int's count of sources, two boxes a level
  int count = 0;
  open[static_cast<std::size_t>(count++)] = 0;
  while (count > 0) {
    int index = open[static_cast<std::size_t>(--count)];
    const Box& box = boxes_[static_cast<std::size_t>(index)];
    if (bound(box, x) >= best) continue;
    for (int i = box.first; i < box.first + box.count; ++i) {
      const SizeSource& source = sources_[static_cast<std::size_t>(i)];
      best = std::min(best, source.h + gradation_ * distance_to_segment(x, source.a, source.b));
    }
    if (box.count > 0) continue;
    int near = index + 1, far = box.second_child;
    if (bound(boxes_[static_cast<std::size_t>(far)], x) < bound(boxes_[static_cast<std::size_t>(near)], x))
      std::swap(near, far);
    open[static_cast<std::size_t>(count++)] = far;
    open[static_cast<std::size_t>(count++)] = near;
  }
  return best;
}

}  // namespace paver
