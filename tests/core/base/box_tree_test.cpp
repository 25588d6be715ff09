#include "base/boxes/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace paver {
namespace {

class Places {
 public:
  Vec3 next() { return {share_(random_), share_(random_), share_(random_)}; }
  std::vector<Box> boxes(std::size_t count, double size) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
      box.add(next());
      box.add(box.low + size * next());
    }
    return boxes;
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> share_{0, 1};
};

TEST(BoxTree, FindsAllThatMeetABoxEachOnce) {
  Places places;
  for (double size : {0.0, 0.1, 1.0}) {
    const std::vector<Box> boxes = places.boxes(300, size);
    const BoxTree tree(boxes);
    for (const Box& box : places.boxes(30, 0.3)) {
      std::vector<int> found, expected;
      tree.each_meeting(box, [&](int i) { found.push_back(i); });
      std::ranges::sort(found);
      for (int i = 0; i < 300; ++i)
        if (boxes[i].meets(box)) expected.push_back(i);
      EXPECT_EQ(found, expected) << size;
    }
  }
}

TEST(BoxTree, TheLeastValueIsThatOfAllAndFewAreLookedAt) {
  Places places;
  const std::size_t count = 1000;
  const std::vector<Box> points = places.boxes(count, 0);
  std::vector<double> starts;
  for (std::size_t i = 0; i < count; ++i) starts.push_back(0.01 * static_cast<double>(i % 7) - 0.02);
  const BoxTree tree(points, starts);
  int looked_at = 0;
  for (int k = 0; k < 100; ++k) {
    const Vec3 x = places.next();
    // Some do not count.
    auto value = [&](int i) { return i % 3 == 0 ? INFINITY : starts[i] + 0.5 * norm(points[i].low - x); };
    double expected = INFINITY;
    for (std::size_t i = 0; i < count; ++i) expected = std::min(expected, value(static_cast<int>(i)));
    EXPECT_EQ(tree.least(x, INFINITY, 0.5, [&](int i) { return ++looked_at, value(i); }), expected);
    EXPECT_EQ(tree.least(x, expected - 0.01, 0.5, value), expected - 0.01);
  }
  EXPECT_LT(looked_at, 100 * 100);
}

TEST(BoxTree, OfNoBoxesHasNone) {
  const BoxTree tree(std::vector<Box>{});
  EXPECT_EQ(tree.least({}, 1, 1, [](int) { return 0.0; }), 1);
  tree.each_meeting({{0, 0, 0}, {1, 1, 1}}, [](int) { FAIL(); });
}

}  // namespace
}  // namespace paver
