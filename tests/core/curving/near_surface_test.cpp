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
  SurfaceSlope slope(Vec2 uv) const override {
    const Vec3 x = point(uv);
    return {x, {-x.y, x.x, 0}, {s_ * std::cos(uv.x), s_ * std::sin(uv.x), c_}};
  }
  SurfaceJet jet(Vec2 uv) const override {
    const SurfaceSlope at = slope(uv);
    return {at, {-at.x.x, -at.x.y, 0}, {-at.v.y, at.v.x, 0}};
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

/// The parabola x = sharpness y^2, y = u, swept along z: a nose at u = 0.
class Nose : public Surface {
 public:
  explicit Nose(double sharpness) : sharpness_(sharpness) {}
  Vec3 point(Vec2 uv) const override { return {sharpness_ * uv.x * uv.x, uv.x, uv.y}; }
  SurfaceSlope slope(Vec2 uv) const override { return {point(uv), {2 * sharpness_ * uv.x, 1, 0}, {0, 0, 1}}; }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv), {2 * sharpness_, 0, 0}}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Nose>(*this); }

 private:
  double sharpness_;
};

struct Side {
  Region region;
  RegionMesh mesh;
  int v = 0, w = 0;

  Side(std::shared_ptr<const Surface> surface, Vec2 from, Vec2 to) {
    region.chart = make_row_chart(*surface, {{-0.2, -1}, {1.4, 1}, false, false, false});
    region.surface = std::move(surface);
    v = mesh.add_node(region.place(region.chart->to_chart(from)), 1);
    w = mesh.add_node(region.place(region.chart->to_chart(to)), 1);
  }
  Vec3 middle() const {
    Vec2 p = guess_middle(region, mesh, v, w, {});
    return side_middle(region, side_end(mesh, v, mesh.x[v]), side_end(mesh, w, mesh.x[w]), {}, p);
  }
  Vec3 nearest_to_chord() const {
    Vec2 p = guess_middle(region, mesh, v, w, {});
    return nearest_point(region, p, 0.5 * (mesh.x[v] + mesh.x[w]), norm(mesh.x[w] - mesh.x[v]));
  }
  /// Of the parabola through the ends and `x`, from the surface.
  double off(Vec3 x) const {
    double most = 0;
    for (double t = 0.05; t < 1; t += 0.05) {
      const Vec3 at = (1 - 2 * t) * (1 - t) * mesh.x[v] + 4 * t * (1 - t) * x - t * (1 - 2 * t) * mesh.x[w];
      double nearest = INFINITY;
      for (double u = -0.2; u < 1.2; u += 1e-3) nearest = std::min(nearest, norm(region.surface->point({u, 0}) - at));
      most = std::max(most, nearest);
    }
    return most;
  }
};

TEST(SideMiddle, LiesNearerToANoseThanToTheOtherEnd) {
  for (bool is_turned : {false, true}) {
    const Side side(std::make_shared<Nose>(6), {is_turned ? 1.0 : 0.0, 0}, {is_turned ? 0.0 : 1.0, 0});
    EXPECT_GT(side.off(side.nearest_to_chord()), 0.04);
    EXPECT_LT(side.off(side.middle()), 0.6 * side.off(side.nearest_to_chord())) << is_turned;
    EXPECT_LT(std::abs(side.middle().x - 6 * side.middle().y * side.middle().y), 1e-3);
    EXPECT_GT(side.middle().x, 0.3 * 6);  // not so near that the Jacobian would be small
  }
}

/// u about the ring, v about the tube.
class Ring : public Surface {
 public:
  Vec3 point(Vec2 uv) const override {
    const double r = 5.7 + 0.3 * std::cos(uv.y);
    return {r * std::cos(uv.x), r * std::sin(uv.x), 0.3 * std::sin(uv.y)};
  }
  SurfaceSlope slope(Vec2 uv) const override {
    const Vec3 x = point(uv);
    const double s = -0.3 * std::sin(uv.y);
    return {x, {-x.y, x.x, 0}, {s * std::cos(uv.x), s * std::sin(uv.x), 0.3 * std::cos(uv.y)}};
  }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv)}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {2 * pi, 2 * pi}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Ring>(*this); }
};

TEST(SideMiddle, StaysOnItsRowOfAFilletThatIsThinAgainstIt) {
  const auto ring = std::make_shared<Ring>();
  const Side side(ring, {0, 0.8}, {0.6, 0.8});
  const Vec3 half_way = ring->point({0.3, 0.8});
  EXPECT_GT(norm(side.nearest_to_chord() - half_way), 0.1) << "on another row";
  EXPECT_LT(norm(side.middle() - half_way), 0.02);
}

TEST(SideMiddle, StaysOnItsRowOfATubeThatBends) {
  const auto ring = std::make_shared<Ring>();
  for (double bend : {0.15, 0.3, pi / 4}) {
    const Side side(ring, {0, pi / 2}, {bend, pi / 2});
    const Vec3 half_way = ring->point({bend / 2, pi / 2});
    EXPECT_GT(norm(side.nearest_to_chord() - half_way), 0.01) << "slides round the tube";
    EXPECT_LT(norm(side.middle() - half_way), 1e-3) << bend;
  }
}

TEST(SideMiddle, IsTheNearestToTheMiddleOfTheChordWhereTheSideBendsEvenly) {
  const Side side(std::make_shared<fake::Cylinder>(2), {0.3, 0}, {1.2, 0.5});
  EXPECT_EQ(norm(side.middle() - side.nearest_to_chord()), 0);
}

}  // namespace
}  // namespace paver
