// Boxes near a place, by a tree of boxes.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/box.h"

namespace paver {

/// Answers depend on the set of the boxes only, whatever the order in which they are looked at.
class BoxTree {
 public:
  BoxTree() = default;
  /// `starts`: per box the least value of what lies in it, see least(); all 0 where empty.
  explicit BoxTree(std::vector<Box> boxes, std::vector<double> starts = {});

  /// visit(i) for each box that meets `box`.
  template <class Visit>
  void each_meeting(const Box& box, Visit visit) const {
    auto is_apart = [&](const Branch& branch) { return branch.box.meets(box) ? 0.0 : 1.0; };
    search(1, is_apart, [&](int i) {
      if (boxes_[i].meets(box)) visit(i);
      return 1.0;
    });
  }

  /// Least of value(i) over all boxes, and `most`. value(i): of what lies in box i, its own plus `growth` times its
  /// distance from x, or more. What cannot matter is not looked at.
  template <class Value>
  double least(Vec3 x, double most, double growth, Value value) const {
    auto bound = [&](const Branch& branch) { return branch.start + nearer * growth * away(branch.box, x); };
    search(most, bound, [&](int i) { return most = std::min(most, value(i)); });
    return most;
  }

 private:
  static constexpr double nearer = 1 - 1e-12;  // for rounding
  struct Branch {
    Box box;
    double start = 0;          // least in it
    int first = 0, count = 0;  // of order_; count 0: an inner one
    int second_child = -1;     // the first one follows its parent
  };
  int add_branch(int first, int count);
  /// To the nearest point of a box.
  static double away(const Box& box, Vec3 x) {
    auto outside = [](double value, double low, double high) { return std::max({low - value, value - high, 0.0}); };
    const auto& [low, high] = box;
    return norm(Vec3{outside(x.x, low.x, high.x), outside(x.y, low.y, high.y), outside(x.z, low.z, high.z)});
  }

  struct Open {
    int index;
    double bound;
  };

  /// look(i), which gives the limit from then on, in all leaves whose bound() is below it, the lower one of two first.
  template <class Bound, class Look>
  void search(double limit, Bound bound, Look look) const {
    std::array<Open, 64> open;  // depth of a tree over an int's count of boxes, two branches a level
    int count = 0;
    if (!branches_.empty()) open[count++] = {0, bound(branches_[0])};
    while (count > 0) {
      const Open next = open[--count];
      if (!(next.bound < limit)) continue;
      const Branch& branch = branches_[next.index];
      for (int k = branch.first; k < branch.first + branch.count; ++k) limit = look(order_[k]);
      if (branch.count > 0) continue;
      Open near{next.index + 1, bound(branches_[next.index + 1])};
      Open far{branch.second_child, bound(branches_[branch.second_child])};
      if (far.bound < near.bound) std::swap(near, far);
      if (far.bound < limit) open[count++] = far;
      if (near.bound < limit) open[count++] = near;
    }
  }

  std::vector<Box> boxes_;
  std::vector<double> starts_;
  std::vector<int> order_;
  std::vector<Branch> branches_;
};

}  // namespace paver
