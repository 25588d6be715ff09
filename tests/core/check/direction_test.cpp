// Which way elements run, where corners lie on lips that are narrow against them or on the other side of a thin body.
#include "check/direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "charts/chart.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// A plane, upwards, whose strip of u below `wide` is curled under: the normal at u = 0 points downwards.
class Curled : public Surface {
 public:
  explicit Curled(double wide) : wide_(wide) {}
  Vec3 point(Vec2 uv) const override {
    if (uv.x >= wide_) return {uv.x, uv.y, 0};
    const double angle = curl * (wide_ - uv.x) / wide_, radius = wide_ / curl;
    return {wide_ - radius * std::sin(angle), uv.y, -radius * (1 - std::cos(angle))};
  }
  SurfaceSlope slope(Vec2 uv) const override {
    const double angle = uv.x >= wide_ ? 0 : curl * (wide_ - uv.x) / wide_;
    return {point(uv), {std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}};
  }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv)}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Curled>(*this); }

 private:
  static constexpr double curl = 2.5;  // radians
  double wide_;
};

Region region_on(double wide) {
  Region region;
  region.surface = std::make_shared<Curled>(wide);
  region.chart = make_row_chart(*region.surface, {{0, 0}, {1, 1}});
  return region;
}

/// Of the triangle between two places on the lip and one far from it, `turn`: 1 or -1 times its normal.
bool runs(double wide, double turn) {
  const Region region = region_on(wide);
  std::array<Vec2, 4> places;
  std::array<Vec3, 3> x;
  ElementNormals normals;
  const Vec2 corners[] = {{1, 0.5}, {0, 0.8}, {0, 0.2}};
  for (std::size_t k = 0; k < 3; ++k) {
    const NodePlace node = region.place(places[k] = region.chart->to_chart(corners[k]));
    x[k] = node.x, normals.corners += unit(cross(node.xp, node.xq));
  }
  normals.area = normals.centre = turn * cross(x[1] - x[0], x[2] - x[0]);
  return runs_with_surface(region, 3, places, normals);
}

TEST(Direction, OfAnElementWithCornersOnANarrowLipIsThatOfItsInside) {
  EXPECT_TRUE(runs(0.01, 1));
  EXPECT_FALSE(runs(0.01, -1));
}

TEST(Direction, IsNotGoodWhereTheLipIsPartOfTheElement) { EXPECT_FALSE(runs(0.3, 1)); }

}  // namespace
}  // namespace paver
