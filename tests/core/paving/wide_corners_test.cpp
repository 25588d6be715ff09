// Corners that rows run past.
#include "paving/front/wide_corners.h"

#include <gtest/gtest.h>

#include <cmath>

namespace paver {
namespace {

using Corners = std::vector<std::size_t>;

constexpr double deg = M_PI / 180, straight = 180 * deg;

TEST(WideCorners, EveryOtherOneOfAHexagonIsPassed) {
  EXPECT_EQ(passed_corners(std::vector<double>(6, 120 * deg)), (Corners{1, 3, 5}));
  EXPECT_EQ(passed_corners({120 * deg, straight, 120 * deg, straight, 120 * deg, straight, 120 * deg, straight,
                            120 * deg, straight, 120 * deg, straight}),
            (Corners{2, 6, 10}));
}

TEST(WideCorners, OfParallelogramsEndRows) {
  EXPECT_TRUE(passed_corners({120 * deg, 60 * deg, 120 * deg, 60 * deg}).empty());
  EXPECT_TRUE(passed_corners({90 * deg, 60 * deg, 120 * deg, 90 * deg}).empty());
  EXPECT_TRUE(passed_corners({90 * deg, 90 * deg, 90 * deg, 90 * deg}).empty());
}

TEST(WideCorners, OneByItselfEndsRows) {
  EXPECT_TRUE(passed_corners({straight, 120 * deg, straight, straight}).empty());
  EXPECT_TRUE(passed_corners({straight, straight}).empty());
  EXPECT_TRUE(passed_corners({270 * deg, 270 * deg, 270 * deg, 270 * deg}).empty()) << "a hole";
}

TEST(WideCorners, OfSevenFourArePassed) {
  EXPECT_EQ(passed_corners(std::vector<double>(7, straight - 2 * M_PI / 7)).size(), 4u);
}

}  // namespace
}  // namespace paver
