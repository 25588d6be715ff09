#include "topology/corner_angle.h"

#include <gtest/gtest.h>

#include "support/fake_model.h"

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

/// Along x from (0, 0), but leaves it at an angle of `rise` to x, which fades within `width`.
class Hooked : public Curve {
 public:
  Hooked(double rise, double width) : slope_(std::tan(rise)), width_(width) {}
  Vec3 point(double t) const override { return {t, -slope_ * width_ * std::expm1(-t / width_), 0}; }
  CurveSlope slope(double t) const override { return {point(t), {1, slope_ * std::exp(-t / width_), 0}}; }
  CurveJet jet(double t) const override { return {slope(t), {0, -slope_ / width_ * std::exp(-t / width_), 0}}; }

 private:
  double slope_, width_;
};

/// Between that curve and the y axis.
double angle_at_hook(double rise, double width, bool is_reversed) {
  Model model;
  model.edges.resize(2);
  model.edges[0].curve = std::make_shared<fake::Line>(Vec3{0, 0, 0}, Vec3{0, 1, 0});
  model.edges[1].curve = std::make_shared<Hooked>(rise, width);
  for (Edge& edge : model.edges) edge.t1 = 1;
  return is_reversed ? corner_angle(model, {}, {1, true, nullptr}, {0, false, nullptr})
                     : corner_angle(model, {}, {0, true, nullptr}, {1, false, nullptr});
}

TEST(CornerAngle, IsThatBehindAHookAtTheEndOfACurve) {
  for (bool is_reversed : {false, true}) {
    EXPECT_NEAR(angle_at_hook(1.5, 1e-5, is_reversed), M_PI / 2, 1e-6);
    EXPECT_NEAR(angle_at_hook(1.5, 0.1, is_reversed), M_PI / 2 - 1.5, 1e-6) << "a tenth of the curve is no hook";
    EXPECT_NEAR(angle_at_hook(0.3, 1e-5, is_reversed), M_PI / 2 - 0.3, 1e-6) << "the curve turns little";
  }
}

}  // namespace
}  // namespace paver
