#include "curving/closest_point.h"

#include <gtest/gtest.h>

#include "support/fake_model.h"

namespace paver {
namespace {

TEST(ClosestOnSurface, AFlatFaceNeedsOneStep) {
  fake::Plane plane({1, 2, 3}, {2, 0, 0}, {1, 1, 0});
  Vec2 uv{10, -7};
  Vec3 x;
  ASSERT_TRUE(closest_on_surface(plane, uv, {4, 5, 9}, x));
  EXPECT_NEAR(norm(x - Vec3{4, 5, 3}), 0, 1e-12);
}

TEST(ClosestOnSurface, ACylinderIsReachedAcrossATurn) {
  fake::Cylinder cylinder(2);
  for (double off : {-0.5, 0.0, 0.7}) {
    Vec2 uv{0.4, 0};
    Vec3 x, target{(2 + off) * std::cos(1.0), (2 + off) * std::sin(1.0), 5};
    ASSERT_TRUE(closest_on_surface(cylinder, uv, target, x));
    EXPECT_NEAR(uv.x, 1.0, 1e-9);
    EXPECT_NEAR(uv.y, 5.0, 1e-9);
    EXPECT_NEAR(norm(target - x), std::abs(off), 1e-9);
  }
}

TEST(ClosestOnSurface, ASphereOfAnySizeIsReached) {
  for (double radius : {1e-3, 1.0, 1e5}) {
    fake::Sphere sphere(radius);
    Vec3 target = 0.9 * sphere.point({0.7, 0.3}), x;
    Vec2 uv{0.5, 0.5};
    ASSERT_TRUE(closest_on_surface(sphere, uv, target, x)) << radius;
    EXPECT_NEAR(norm(x - sphere.point({0.7, 0.3})) / radius, 0, 1e-11);
  }
}

TEST(ClosestOnSurface, ABSplineIsMetAtRightAngles) {
  fake::CubicPatch patch = fake::hill(0.8);
  for (Vec2 guess : {Vec2{0.4, 0.4}, Vec2{0.5, 0.7}, Vec2{0.25, 0.35}}) {
    Vec2 uv = guess;
    Vec3 x, xu, xv, target{0.45, 0.5, 0.6};
    ASSERT_TRUE(closest_on_surface(patch, uv, target, x));
    patch.d1(uv, x, xu, xv);
    EXPECT_NEAR(dot(target - x, xu), 0, 1e-12);
    EXPECT_NEAR(dot(target - x, xv), 0, 1e-12);
    EXPECT_LT(norm(target - x), 0.2);
  }
}

TEST(ClosestOnSurface, AGuessThatIsTheAnswerStays) {
  fake::CubicPatch patch = fake::hill(0.8);
  Vec2 uv{0.3, 0.6};
  Vec3 x;
  ASSERT_TRUE(closest_on_surface(patch, uv, patch.point({0.3, 0.6}), x));
  EXPECT_NEAR(uv.x, 0.3, 1e-15);
  EXPECT_NEAR(uv.y, 0.6, 1e-15);
}

TEST(ClosestOnSurface, APoleIsRefusedAndNothingBecomesInfinite) {
  fake::Sphere sphere(1);
  Vec2 uv{0, fake::pi / 2};
  Vec3 x;
  EXPECT_FALSE(closest_on_surface(sphere, uv, {0.3, 0.3, 1}, x));
  EXPECT_TRUE(std::isfinite(uv.x) && std::isfinite(x.z));
  Vec2 good{0.1, 0.1};
  EXPECT_FALSE(closest_on_surface(sphere, good, {std::nan(""), 0, 0}, x));
  EXPECT_TRUE(std::isfinite(good.x) && std::isfinite(good.y));
}

TEST(ClosestOnSurface, TheCentreOfASphereGivesAFinitePoint) {
  fake::Sphere sphere(1);
  Vec2 uv{0.1, 0.1};
  Vec3 x;
  closest_on_surface(sphere, uv, {0, 0, 0}, x);
  EXPECT_NEAR(norm(x), 1, 1e-12);
}

}  // namespace
}  // namespace paver
