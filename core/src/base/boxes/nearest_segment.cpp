#include "base/boxes/nearest_segment.h"

#include "base/segment.h"

namespace paver {

NearestSegment::NearestSegment(std::vector<Segment> segments, double growth)
    : segments_(std::move(segments)), growth_(growth) {
  std::vector<Box> boxes;
  std::vector<double> values;
  for (const Segment& segment : segments_) {
    boxes.emplace_back().add(segment.a);
    boxes.back().add(segment.b);
    values.push_back(segment.value);
  }
  tree_ = BoxTree(std::move(boxes), std::move(values));
}

double NearestSegment::value_at(Vec3 x, const Segment& segment) const {
  return segment.value + growth_ * distance_to_segment(x, segment.a, segment.b);
}

double NearestSegment::least(Vec3 x, double most) const {
  return tree_.least(x, most, growth_, [&](int i) { return value_at(x, segments_[i]); });
}

double NearestSegment::least_of_others(Vec3 x, double most, int group) const {
  return tree_.least(x, most, growth_,
                     [&](int i) { return segments_[i].group == group ? most : value_at(x, segments_[i]); });
}

}  // namespace paver
