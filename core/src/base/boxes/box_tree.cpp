// Boxes are halved at the middle of their order along the longest side of what holds them all.
#include "base/boxes/box_tree.h"

#include <algorithm>
#include <numeric>

namespace paver {
namespace {

constexpr int few = 4;  // boxes of a leaf

}  // namespace

BoxTree::BoxTree(std::vector<Box> boxes, std::vector<double> starts)
    : boxes_(std::move(boxes)), starts_(std::move(starts)), order_(boxes_.size()) {
  starts_.resize(boxes_.size(), 0);
  std::iota(order_.begin(), order_.end(), 0);
  if (!boxes_.empty()) add_branch(0, static_cast<int>(boxes_.size()));
}

int BoxTree::add_branch(int first, int count) {
  const auto begin = order_.begin() + first, end = begin + count;
  Branch branch{{}, starts_[*begin], first, count};
  for (auto i = begin; i != end; ++i) {
    branch.box.add(boxes_[*i]);
    branch.start = std::min(branch.start, starts_[*i]);
  }
  const int index = static_cast<int>(branches_.size());
  branches_.push_back(branch);
  if (count <= few) return index;
  const Vec3 size = branch.box.high - branch.box.low;
  const bool is_x = size.x >= size.y && size.x >= size.z, is_y = !is_x && size.y >= size.z;
  auto place = [&](int i) {
    const Vec3 twice = boxes_[i].low + boxes_[i].high;
    return is_x ? twice.x : is_y ? twice.y : twice.z;
  };
  const int half = count / 2;
  std::nth_element(begin, begin + half, end, [&](int i, int j) { return place(i) < place(j); });
  add_branch(first, half);
  const int second = add_branch(first + half, count - half);
  branches_[index].count = 0;
  branches_[index].second_child = second;
  return index;
}

}  // namespace paver
