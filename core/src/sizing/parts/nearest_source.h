// Where around many straight sources of length the target length is least.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "base/box.h"

namespace paver {

/// A straight piece from a to b (a point where they are equal) with the target length on it, mm.
struct SizeSource {
  Vec3 a, b;
  double h = 0;
  int group = -1;  ///< what a search may leave out
};

/// Tree of boxes over sources. The answer depends on their set only, not on its order.
class NearestSource {
 public:
  NearestSource() = default;
  NearestSource(std::vector<SizeSource> sources, double gradation);

  /// Least over all sources of h + gradation * distance from x; `most` where that is more. What cannot matter is not
  /// looked at, so that far from all sources an answer costs next to nothing.
  double least(Vec3 x, double most = std::numeric_limits<double>::infinity()) const { return search(x, most, none); }
  /// The same over all sources but those of a group.
  double least_of_others(Vec3 x, double most, int group) const { return search(x, most, group); }

 private:
  struct Branch {
    Box box;
    double h = 0;              // least in it
    int first = 0, count = 0;  // of the sources; count 0: an inner one
    int second_child = -1;     // the first one follows its parent
  };
  static constexpr int none = -2;  // no source's group
  double search(Vec3 x, double most, int left_out) const;
  int add_branch(int first, int count);
  double bound(const Branch& branch, Vec3 x) const;

  std::vector<SizeSource> sources_;
  std::vector<Branch> branches_;
  double gradation_ = 0;
};

}  // namespace paver
