// Steps: halves of the boxes along the longest side of what holds them all; pairs within each; pairs between both.
#include "base/boxes/box_pairs.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace paver {
namespace {

class BoxPairs {
 public:
  BoxPairs(const std::vector<Box>& boxes, const std::function<bool(int, int)>& visit) : boxes_(boxes), visit_(visit) {}

  void search(const std::vector<int>& all) {
    if (all.size() < 2 || is_over_) return;
    auto [low, high] = halves(all);
    search(low);
    search(high);
    meet(std::move(low), std::move(high));
  }

 private:
  // Those of either that the other's box does not meet are left out on the way.
  void meet(std::vector<int> a, std::vector<int> b) {
    if (is_over_) return;
    keep_meeting(a, b);
    keep_meeting(b, a);
    constexpr std::size_t few = 64;
    if (a.empty() || b.empty()) return;
    if (a.size() * b.size() <= few || std::min(a.size(), b.size()) == 1) {
      for (int i : a)
        for (int j : b)
          if (!is_over_ && boxes_[i].meets(boxes_[j])) is_over_ = !visit_(i, j);
      return;
    }
    std::vector<int>& larger = a.size() >= b.size() ? a : b;
    const std::vector<int> other = a.size() >= b.size() ? b : a;
    auto [low, high] = halves(larger);
    meet(std::move(low), other);
    meet(std::move(high), other);
  }

  Box box_of(const std::vector<int>& some) const {
    Box box;
    for (int i : some) box.add(boxes_[i]);
    return box;
  }

  void keep_meeting(std::vector<int>& a, const std::vector<int>& b) const {
    const Box box = box_of(b);
    std::erase_if(a, [&](int i) { return !boxes_[i].meets(box); });
  }

  std::pair<std::vector<int>, std::vector<int>> halves(std::vector<int> all) const {
    const Box box = box_of(all);
    const Vec3 size = box.high - box.low;
    const bool is_x = size.x >= size.y && size.x >= size.z, is_y = !is_x && size.y >= size.z;
    auto along = [&](Vec3 x) { return is_x ? x.x : is_y ? x.y : x.z; };
    auto place = [&](int i) { return std::pair(along(boxes_[i].low + boxes_[i].high), i); };
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end(), [&](int i, int j) { return place(i) < place(j); });
    return {{all.begin(), middle}, {middle, all.end()}};
  }

  const std::vector<Box>& boxes_;
  const std::function<bool(int, int)>& visit_;
  bool is_over_ = false;
};

}  // namespace

void for_meeting(const std::vector<Box>& boxes, const std::function<bool(int i, int j)>& visit) {
  std::vector<int> all(boxes.size());
  std::iota(all.begin(), all.end(), 0);
  BoxPairs(boxes, visit).search(all);
}

}  // namespace paver
