#include "topology/corner_angle.h"

#include <gtest/gtest.h>

namespace paver {
namespace {

TEST(AngleBetween, IsThatOfTheDirections) {
  EXPECT_NEAR(angle_between({1, 0, 0}, {0, 3, 0}), M_PI / 2, 1e-15);
  EXPECT_NEAR(angle_between({1, 0, 0}, {-2, 0, 0}), M_PI, 1e-15);
}

TEST(AngleBetween, IsNoneWhereADirectionIsNone) {
  for (Vec3 direction : {Vec3{1, 2, 3}, Vec3{-1, -2, -3}, Vec3{}}) {
    EXPECT_EQ(angle_between({}, direction), 0);
    EXPECT_EQ(angle_between(direction, {}), 0);
  }
}

}  // namespace
}  // namespace paver
