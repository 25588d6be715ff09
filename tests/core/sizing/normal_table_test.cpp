#include "sizing/normal_table.h"

#include <gtest/gtest.h>

#include "support/fake_model.h"

namespace paver {
namespace {

constexpr double radius = 10;

NormalTable table_of(const Model& model, double spacing, double reach) {
  const Face& face = model.faces[0];
  return NormalTable(*face.surface, sample_box(model, face), {spacing, spacing}, reach);
}

TEST(NormalTable, FollowsTheNormalsOfACylinder) {
  const Model tube = fake::tube(radius, 40);
  const NormalTable table = table_of(tube, 0.5, 0.5);
  for (double u : {0.1, 1.0, 3.3, 6.2}) {
    const auto [x, xu, xv] = tube.faces[0].surface->slope({u, 7});
    const Vec3 n = unit(cross(xu, xv));
    EXPECT_NEAR(norm(table.at({u, 7}) - n), 0, 1e-3) << u;
    Vec3 by_u, by_v;
    table.slopes({u, 7}, {norm(xu), norm(xv)}, by_u, by_v);
    EXPECT_NEAR(norm(by_u), 1, 5e-3) << u;  // a radian of the normal per radian of the parameter
    EXPECT_NEAR(norm(by_v), 0, 1e-9) << u;
  }
}

TEST(NormalTable, GoesOnPastThePeriod) {
  const Model tube = fake::tube(radius, 40);
  const NormalTable table = table_of(tube, 0.5, 0.5);
  const double period = tube.faces[0].surface->period().x;
  ASSERT_GT(period, 0);
  for (double u : {-0.2, 0.0, 0.3, 6.0}) {
    EXPECT_NEAR(norm(table.at({u + period, 3}) - table.at({u, 3})), 0, 1e-9) << u;
    EXPECT_NEAR(norm(table.at({u - period, 3}) - table.at({u, 3})), 0, 1e-9) << u;
  }
  EXPECT_GT(norm(table.at({std::nan(""), 3})), 0.9);
}

TEST(NormalTable, ATurnSharperThanTheSpacingIsSpreadOverIt) {
  const Model tube = fake::tube(0.01, 40);  // 0.06 around: a full turn within a fraction of the spacing
  const NormalTable table = table_of(tube, 1, 0.5);
  double way = 0;
  for (int i = 0; i < 64; ++i) way += norm(table.at({0.1 * (i + 1), 3}) - table.at({0.1 * i, 3}));
  EXPECT_LT(way, 2 * M_PI * 0.07);
}

TEST(NormalTable, StretchesAreasByTheTurn) {
  const Model tube = fake::tube(radius, 40);
  const NormalTable table = table_of(tube, 0.2, 0.2);
  EXPECT_NEAR(table.stretched_area(0), 1, 1e-12);
  for (double weight : {2.0, 10.0, 50.0})
    EXPECT_NEAR(table.stretched_area(weight), std::sqrt(1 + weight * weight / (radius * radius)), 0.01) << weight;
}

// Along a cylinder's axis a few lines do.
TEST(NormalTable, LinesMayLieFartherApartWhereNothingTurns) {
  const Model tube = fake::tube(radius, 40);
  const Face& face = tube.faces[0];
  const SampleBox box = sample_box(tube, face);
  const NormalTable wide(*face.surface, box, {0.5, 16}, 0.5), narrow(*face.surface, box, {0.5, 0.5}, 0.5);
  for (double u : {0.1, 3.3, 6.2})
    for (double v : {0.0, 7.0, 39.0}) EXPECT_NEAR(norm(wide.at({u, v}) - narrow.at({u, v})), 0, 1e-12);
  EXPECT_NEAR(wide.stretched_area(5), narrow.stretched_area(5), 1e-9);
}

TEST(NormalTable, PolesTakeTheNormalsBesideThem) {
  const Model ball = fake::ball(radius);
  const NormalTable table = table_of(ball, 1, 1);
  EXPECT_NEAR(norm(table.at({1, -fake::pi / 2})), 1, 0.02);
  EXPECT_NEAR(norm(table.at({1, fake::pi / 2})), 1, 0.02);
}

/// A ball whose derivatives at its poles are rounding in a direction of its own, as splines have them.
class RoundedBall : public fake::Sphere {
 public:
  RoundedBall() : Sphere(radius) {}
  SurfaceSlope slope(Vec2 uv) const override {
    SurfaceSlope at = Sphere::slope(uv);
    if (std::abs(uv.y) > fake::pi / 2 - 1e-9) at.u = {3e-15, 0, 5e-15};
    return at;
  }
};

TEST(NormalTable, RoundingAtPolesIsNoNormal) {
  Model ball = fake::ball(radius);
  ball.faces[0].surface = std::make_shared<RoundedBall>();
  const NormalTable table = table_of(ball, 1, 1), plain = table_of(fake::ball(radius), 1, 1);
  for (double u : {0.1, 2.0, 5.0})
    for (double v : {-fake::pi / 2, -1.55, 1.55, fake::pi / 2})
      EXPECT_NEAR(norm(table.at({u, v}) - plain.at({u, v})), 0, 1e-12) << u << " " << v;
}

}  // namespace
}  // namespace paver
