// Boxes near a place, by a tree of boxes.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "base/box.h"

namespace paver {

/// Answers depend on the set of the boxes only, whatever the order in which they are looked at.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes);

  /// visit(i) for each box that meets `box`.
  template <class Visit>
  void each_meeting(const Box& box, Visit visit) const {
    search([&](const Branch& branch) { return branch.box.meets(box); },
           [&](int i) {
             if (boxes_[i].meets(box)) visit(i);
           });
  }

  /// Least of distance(i) over all boxes, and `most`. distance(i): from x to what lies in box i, or more.
  template <class Distance>
  double least(Vec3 x, double most, Distance distance) const {
    search([&](const Branch& branch) { return nearer * away(branch.box, x) < most; },
           [&](int i) { most = std::min(most, distance(i)); });
    return most;
  }

 private:
  static constexpr double nearer = 1 - 1e-12;  // for rounding
  struct Branch {
    Box box;
    int first = 0, count = 0;  // of order_; count 0: an inner one
    int second_child = -1;     // the first one follows its parent
  };
  int add_branch(int first, int count);
  /// To the nearest point of a box.
  static double away(const Box& box, Vec3 x);

  /// look(i) in all leaves that is_wanted() holds for, and for all they are in.
  template <class IsWanted, class Look>
  void search(IsWanted is_wanted, Look look) const {
    std::array<int, 64> open;  // depth of a tree over an int's count of boxes, two branches a level
    int count = 0;
    if (!branches_.empty()) open[count++] = 0;
    while (count > 0) {
      const int index = open[--count];
      const Branch& branch = branches_[index];
      if (!is_wanted(branch)) continue;
      for (int k = branch.first; k < branch.first + branch.count; ++k) look(order_[k]);
      if (branch.count > 0) continue;
      open[count++] = branch.second_child;
      open[count++] = index + 1;
    }
  }

  std::vector<Box> boxes_;
  std::vector<int> order_;
  std::vector<Branch> branches_;
};

}  // namespace paver
