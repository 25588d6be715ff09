// A tree of boxes around runs of triangles.
//   1. runs of consecutive triangles, which lie close together in a tessellation
//   2. sorted along a space-filling curve (Morton order of the centres of their boxes)
//   3. each next level: boxes around `fan_out` boxes of the one before
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "paver/pick.h"

namespace paver {
namespace {

constexpr std::size_t run_length = 8;  ///< triangles
constexpr std::size_t fan_out = 4;
constexpr double slack = 1e-9;  ///< barycentric: so much may a line pass a triangle, or it would slip between two

/// The lower 21 bits, two places apart.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

void PickTree::Box::add(const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], box.low[k]);
    high[k] = std::max(high[k], box.high[k]);
  }
}

struct PickTree::Line {
  Vec3 origin, direction;
  std::array<double, 3> from, inverse;  ///< origin, 1 / direction
  double margin;                        ///< by which boxes are widened against rounding

  bool meets(const Box& box) const {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      double low = box.low[k] - margin, high = box.high[k] + margin;
      if (std::isinf(inverse[k])) {
        if (from[k] < low || from[k] > high) return false;
        continue;
      }
      double a = (low - from[k]) * inverse[k], b = (high - from[k]) * inverse[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }
};

PickTree::PickTree(std::span<const float> points, std::span<const int> triangles)
    : points_(points), triangles_(triangles) {
  std::size_t count = triangles.size() / 4;
  std::vector<Box> runs;
  runs.reserve(count / run_length + 1);
  for (std::size_t first = 0; first < count; first += run_length) {
    Box box;
    for (std::size_t t = first; t < std::min(first + run_length, count); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const float* x = points_.data() + 3 * static_cast<std::size_t>(triangles_[4 * t + k]);
        box.add({{x[0], x[1], x[2]}, {x[0], x[1], x[2]}});
      }
    }
    runs.push_back(box);
  }
  levels_.push_back(std::move(runs));
  sort_leaves();
  add_levels();
}

void PickTree::sort_leaves() {
  std::vector<Box>& runs = levels_.front();
  Box all;
  for (const Box& box : runs) all.add(box);
  std::vector<std::pair<std::uint64_t, int>> order(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::uint64_t code = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      double extent = double(all.high[k]) - all.low[k];
      double centre = (double(runs[i].low[k]) + runs[i].high[k]) / 2 - all.low[k];
      if (extent > 0) code |= spread(static_cast<std::uint64_t>(centre / extent * 0x1fffff)) << k;
    }
    order[i] = {code, static_cast<int>(i)};
  }
  std::sort(order.begin(), order.end());
  std::vector<Box> sorted;
  sorted.reserve(runs.size());
  leaves_.reserve(runs.size());
  for (auto [code, run] : order) {
    leaves_.push_back(run);
    sorted.push_back(runs[run]);
  }
  runs = std::move(sorted);
}

void PickTree::add_levels() {
  while (levels_.back().size() > 1) {
    std::vector<Box> level;
    const std::vector<Box>& below = levels_.back();
    for (std::size_t first = 0; first < below.size(); first += fan_out) {
      Box box;
      for (std::size_t i = first; i < std::min(first + fan_out, below.size()); ++i) box.add(below[i]);
      level.push_back(box);
    }
    levels_.push_back(std::move(level));
  }
}

Vec3 PickTree::corner(std::size_t triangle, int k) const {
  const float* x =
      points_.data() + 3 * static_cast<std::size_t>(triangles_[4 * triangle + static_cast<std::size_t>(k)]);
  return {x[0], x[1], x[2]};
}

void PickTree::test_leaf(const Line& line, std::size_t leaf, std::vector<PickHit>& hits) const {
  std::size_t first = static_cast<std::size_t>(leaves_[leaf]) * run_length;
  for (std::size_t t = first; t < std::min(first + run_length, triangles_.size() / 4); ++t) {
    Vec3 a = corner(t, 0), ab = corner(t, 1) - a, ac = corner(t, 2) - a, from = line.origin - a;
    Vec3 p = cross(line.direction, ac), q = cross(from, ab);
    double determinant = dot(ab, p);
    if (determinant == 0) continue;  // along the triangle, or a triangle without area
    double u = dot(from, p) / determinant, v = dot(line.direction, q) / determinant;
    double along = dot(ac, q) / determinant;
    if (u >= -slack && v >= -slack && u + v <= 1 + slack && along >= 0) hits.push_back({static_cast<int>(t), along});
  }
}

void PickTree::visit(const Line& line, std::size_t level, std::size_t box, std::vector<PickHit>& hits) const {
  if (!line.meets(levels_[level][box])) return;
  if (level == 0) return test_leaf(line, box, hits);
  std::size_t first = box * fan_out;
  for (std::size_t i = first; i < std::min(first + fan_out, levels_[level - 1].size()); ++i)
    visit(line, level - 1, i, hits);
}

std::vector<PickHit> PickTree::hits(Vec3 origin, Vec3 direction) const {
  std::vector<PickHit> found;
  if (levels_.back().empty() || norm(direction) == 0) return found;
  const Box& all = levels_.back().front();
  double reach = 0;
  for (std::size_t k = 0; k < 3; ++k)
    reach = std::max({reach, std::abs(double(all.low[k])), std::abs(double(all.high[k]))});
  Line line{origin,
            direction,
            {origin.x, origin.y, origin.z},
            {1 / direction.x, 1 / direction.y, 1 / direction.z},
            reach * 1e-7};
  visit(line, levels_.size() - 1, 0, found);
  std::ranges::sort(found, {}, [](const PickHit& hit) { return std::pair(hit.along, hit.triangle); });
  return found;
}

}  // namespace paver
