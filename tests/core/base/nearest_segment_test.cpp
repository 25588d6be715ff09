#include "base/boxes/nearest_segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace paver {
namespace {

double distance_to(Vec3 x, const Segment& segment) {
  double best = INFINITY;
  for (int i = 0; i <= 1000; ++i) best = std::min(best, norm(x - segment.a - (i / 1000.0) * (segment.b - segment.a)));
  return best;
}

TEST(NearestSegment, GivesTheLeastOverAllOrAllButAGroup) {
  std::mt19937 random(7);
  auto number = [&] { return std::uniform_real_distribution<double>(-10, 10)(random); };
  auto point = [&] { return Vec3{number(), number(), number()}; };
  std::vector<std::vector<Segment>> groups(5);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = point();
    groups[i % 5].push_back({a, i % 3 ? a + 0.1 * point() : a, 0.1 + 0.05 * (i % 7)});
  }
  const NearestSegment tree(groups, 0.6);
  for (std::size_t i = 0; i < 200; ++i) {
    const Vec3 x = point();
    double least = INFINITY, of_others = INFINITY;
    for (std::size_t g = 0; g < groups.size(); ++g)
      for (const Segment& segment : groups[g]) {
        const double value = segment.value + 0.6 * distance_to(x, segment);
        least = std::min(least, value);
        if (g != i % 5) of_others = std::min(of_others, value);
      }
    EXPECT_NEAR(tree.least(x), least, 1e-4);
    EXPECT_NEAR(tree.least_of_others(x, INFINITY, i % 5), of_others, 1e-4);
    EXPECT_EQ(tree.least(x, 0.5 * least), 0.5 * least);
  }
  EXPECT_EQ(NearestSegment().least({1, 2, 3}), INFINITY);
}

}  // namespace
}  // namespace paver
