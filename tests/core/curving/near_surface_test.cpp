// Foot points where the chart is far from even: near an apex, along tubes that reach far, with bad guesses.
#include "curving/near_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "charts/chart.h"
#include "support/fake_model.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

/// About the z axis with the apex at the origin; u is the angle, v the distance from the apex.
class Cone : public Surface {
 public:
  explicit Cone(double half_angle) : s_(std::sin(half_angle)), c_(std::cos(half_angle)) {}
  Vec3 point(Vec2 uv) const override { return {uv.y * s_ * std::cos(uv.x), uv.y * s_ * std::sin(uv.x), uv.y * c_}; }
  void d1(Vec2 uv, Vec3& x, Vec3& xu, Vec3& xv) const override {
    x = point(uv);
    xu = {-x.y, x.x, 0};
    xv = {s_ * std::cos(uv.x), s_ * std::sin(uv.x), c_};
  }
  void d2(Vec2 uv, Vec3& x, Vec3& xu, Vec3& xv, Vec3& xuu, Vec3& xuv, Vec3& xvv) const override {
    d1(uv, x, xu, xv);
    xuu = {-x.x, -x.y, 0};
    xuv = {-xv.y, xv.x, 0};
    xvv = {};
  }
  SurfaceKind kind() const override { return SurfaceKind::cone; }
  Vec2 period() const override { return {2 * pi, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Cone>(*this); }

 private:
  double s_, c_;
};

Region region_on(std::shared_ptr<const Surface> surface, const ParameterBox& box) {
  Region region;
  region.chart = make_polar_chart(*surface, box, 2 * pi);
  region.surface = std::move(surface);
  return region;
}

TEST(NearestPoint, StaysOnItsSideOfAnApex) {
  const Region cone = region_on(std::make_shared<Cone>(0.2), {{0, 0}, {2 * pi, 100}, false, true, false});
  for (double distance : {5.0, 16.0, 60.0}) {
    // Half way along the line from the apex: the chart's half way is far off, as it is a power of the distance.
    const Vec3 target = cone.surface->point({1, 0.5 * distance});
    Vec2 p = 0.5 * cone.chart->to_chart({1, distance});
    EXPECT_LT(norm(nearest_point(cone, p, target, distance) - target), 1e-3 * distance) << distance;
  }
}

TEST(NearestPoint, FindsTheMiddleOfASideAlongAThinTube) {
  const Region tube = region_on(std::make_shared<fake::Cylinder>(0.6), {{0, 0}, {2 * pi, 4}, false, false, false});
  const Vec3 target = tube.surface->point({1, 2});
  Vec2 p = half_way(tube, tube.chart->to_chart({1, 0}), tube.chart->to_chart({1, 4}));
  EXPECT_LT(norm(tube.point(p) - target), 1e-9);
  Vec2 bad = 0.5 * (tube.chart->to_chart({1, 0}) + tube.chart->to_chart({1, 4}));
  EXPECT_GT(norm(tube.point(bad) - target), 1);
  EXPECT_LT(norm(nearest_point(tube, bad, target, 4) - target), 1e-3);
}

TEST(NearestPoint, HalvesStepsThatLeadAstray) {
  // On a sphere, from far round it, a full step goes far beyond.
  Region sphere = region_on(std::make_shared<fake::Sphere>(1), {{0, -1.2}, {2 * pi, 1.2}, false, false, false});
  const Vec3 target = 1.5 * sphere.surface->point({2.2, 0.3});
  Vec2 p = sphere.chart->to_chart({0.8, -0.9});
  EXPECT_LT(norm(nearest_point(sphere, p, target, 1) - sphere.surface->point({2.2, 0.3})), 1e-3);
}

}  // namespace
}  // namespace paver
