// Smoothing of closed grids: the energy falls, nodes stay on the surface, squares of equal size stay where they are.
#include "structured/grid_smoothing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "structured/closed_layout.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int around = 24, along = 8;

/// Radii 3 and 1.
class Torus : public Surface {
 public:
  Vec3 point(Vec2 q) const override {
    double r = 3 + std::cos(q.y);
    return {r * std::cos(q.x), r * std::sin(q.x), std::sin(q.y)};
  }
  SurfaceSlope slope(Vec2 q) const override {
    const Vec3 x = point(q);
    return {x, {-x.y, x.x, 0}, {-std::sin(q.y) * std::cos(q.x), -std::sin(q.y) * std::sin(q.x), std::cos(q.y)}};
  }
  SurfaceJet jet(Vec2 q) const override { return {slope(q)}; }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {2 * pi, 2 * pi}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<Torus>(*this); }
};

GluedGrid jittered_grid(double jitter, const Surface& surface, const FaceSize& size) {
  GluedGrid grid;
  grid.charts = {make_plain_chart()};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-jitter, jitter);
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
      grid.mesh.add_node({2 * pi * (i + off(random)) / around, 2 * pi * (j + off(random)) / along}, {}, {}, {}, 0);
  grid.chart.assign(grid.mesh.p.size(), 0);
  for (int v = 0; v < grid.mesh.node_count(); ++v) grid.place(v, grid.mesh.p[v], surface, size);
  auto node = [](int i, int j) { return (j % along) * around + i % around; };
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
      grid.mesh.add_element({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
  return grid;
}

TEST(SmoothGrid, LowersTheEnergyInEverySweep) {
  Torus torus;
  FaceSize size(0.8);
  GluedGrid grid = jittered_grid(0.3, torus, size);
  double before = measure_grid(grid).energy;
  for (int sweep = 0; sweep < 8; ++sweep) {
    smooth_grid(grid, torus, size, 1, {});
    double now = measure_grid(grid).energy;
    EXPECT_LT(now, before * (1 + 1e-3)) << sweep;  // the mean length, which the energy is measured by, may change
    before = now;
  }
}

TEST(SmoothGrid, TakesJitterOutAndKeepsNodesOnTheSurface) {
  Torus torus;
  FaceSize size(0.8);
  GluedGrid grid = jittered_grid(0.35, torus, size), even = jittered_grid(0, torus, size);
  smooth_grid(grid, torus, size, 60, {});
  smooth_grid(even, torus, size, 60, {});
  EXPECT_NEAR(measure_grid(grid).energy, measure_grid(even).energy, 1e-3);
  for (Vec3 x : grid.mesh.x) EXPECT_NEAR(std::hypot(std::hypot(x.x, x.y) - 3, x.z), 1, 1e-12);
}

TEST(MeasureGrid, GivesLengthsAgainstTheTargetLength) {
  Torus torus;
  FaceSize size(0.5), twice(1);
  GridFigures fine = measure_grid(jittered_grid(0, torus, size)), coarse = measure_grid(jittered_grid(0, torus, twice));
  EXPECT_NEAR(fine.mean_ratio, 2 * coarse.mean_ratio, 1e-12);
  EXPECT_NEAR(fine.variation, coarse.variation, 1e-12);
  EXPECT_GT(fine.worst, 0.9);
  EXPECT_GT(fine.turn, 2 * pi / along);
}

}  // namespace
}  // namespace paver
