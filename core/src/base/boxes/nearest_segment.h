// What around many straight pieces is least.
#pragma once

#include <limits>
#include <vector>

#include "base/boxes/box_tree.h"

namespace paver {

/// Straight from a to b (a point where they are equal), with a value that holds on it.
struct Segment {
  Vec3 a, b;
  double value = 0;
};

class NearestSegment {
 public:
  NearestSegment() = default;
  /// Values grow by `growth` times the distance.
  NearestSegment(std::vector<Segment> segments, double growth);
  /// In groups that a search may leave out.
  NearestSegment(const std::vector<std::vector<Segment>>& groups, double growth);

  /// Least over all segments of their value at x, `most` where that is more. Far from all an answer costs next to
  /// nothing.
  double least(Vec3 x, double most = std::numeric_limits<double>::infinity()) const;
  /// The same over all segments but those of a group.
  double least_of_others(Vec3 x, double most, std::size_t group) const;

 private:
  double value_at(Vec3 x, const Segment& segment) const;

  std::vector<Segment> segments_;
  std::vector<std::size_t> group_;  // per segment, where there are any
  double growth_ = 0;
  BoxTree tree_;
};

}  // namespace paver
