#include "base/boxes/nearest_segment.h"

#include "base/segment.h"

namespace paver {
namespace {

std::vector<Segment> joined(const std::vector<std::vector<Segment>>& groups) {
  std::vector<Segment> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace

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

NearestSegment::NearestSegment(const std::vector<std::vector<Segment>>& groups, double growth)
    : NearestSegment(joined(groups), growth) {
  for (std::size_t g = 0; g < groups.size(); ++g) group_.insert(group_.end(), groups[g].size(), g);
}

double NearestSegment::value_at(Vec3 x, const Segment& segment) const {
  return segment.value + growth_ * distance_to_segment(x, segment.a, segment.b);
}

double NearestSegment::least(Vec3 x, double most) const {
  return tree_.least(x, most, growth_, [&](int i) { return value_at(x, segments_[i]); });
}

double NearestSegment::least_of_others(Vec3 x, double most, std::size_t group) const {
  return tree_.least(x, most, growth_, [&](int i) { return group_[i] == group ? most : value_at(x, segments_[i]); });
}

}  // namespace paver
