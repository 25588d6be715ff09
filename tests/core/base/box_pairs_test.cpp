#include "base/boxes/box_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace paver {
namespace {

std::vector<Box> random_boxes(std::size_t count, double size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const Vec3 low{place(random), place(random), place(random)};
    box.add(low);
    box.add(low + size * Vec3{place(random), place(random), place(random)});
  }
  return boxes;
}

TEST(BoxPairs, AreAllThatMeetEachOnce) {
  for (double size : {0.01, 0.1, 1.0}) {
    const std::vector<Box> boxes = random_boxes(300, size);
    std::multiset<std::pair<int, int>> found;
    for_meeting(boxes, [&](int i, int j) {
      found.insert(std::minmax(i, j));
      return true;
    });
    std::multiset<std::pair<int, int>> expected;
    for (int i = 0; i < 300; ++i)
      for (int j = i + 1; j < 300; ++j)
        if (boxes[i].meets(boxes[j])) expected.insert({i, j});
    EXPECT_EQ(found, expected) << size;
  }
}

TEST(BoxPairs, TheSearchEndsWhereItIsTold) {
  int visits = 0;
  for_meeting(std::vector<Box>(2000, random_boxes(1, 1)[0]), [&](int, int) { return ++visits < 5; });
  EXPECT_EQ(visits, 5);
}

}  // namespace
}  // namespace paver
