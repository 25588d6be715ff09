// Lengths and shapes as elements are made, on meshes whose figures are known.
#include "quality/metric_figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/thread_ranks.h"

namespace paver {
namespace {

/// Quads of unequal length round half a cylinder of radius 1 and as long as `along`, one to each `step` of its turn.
RegionMesh tube(double step, double along, double target, double turn_weight) {
  RegionMesh mesh;
  mesh.turn_weight = turn_weight;
  for (int i = 0; i * step < 3.2; ++i)
    for (double z : {0.0, along}) {
      const double angle = i * step;
      const Vec3 n{std::cos(angle), std::sin(angle), 0}, round{-std::sin(angle), std::cos(angle), 0};
      mesh.add_node(NodePlace{{angle, z}, n + Vec3{0, 0, z}, round, {0, 0, 1}, n, round, {}}, target);
    }
  for (int i = 0; 2 * i + 3 < mesh.node_count(); ++i) mesh.add_element({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  return mesh;
}

MetricFigures measure(const std::vector<const RegionMesh*>& meshes) {
  MetricFigures figures;
  test::run_on_ranks(1, [&](Ranks& ranks) { figures = measure_metric(meshes, 2, Progress(), ranks); });
  return figures;
}

TEST(MetricFigures, CountTurnsAsLengths) {
  constexpr double step = 0.2, target = 0.5, weight = 4;
  const RegionMesh mesh = tube(step, target, target, weight);
  const double chord = 2 * std::sin(0.5 * step), round = std::hypot(chord, weight * target * chord) / target;
  const MetricFigures figures = measure({&mesh});
  EXPECT_NEAR(figures.length_mean, 0.5 * (1 + round), 1e-12);
  EXPECT_EQ(figures.length_in_band, 1);
  EXPECT_NEAR(figures.mean_sj, 1, 1e-12);
  EXPECT_NEAR(measure({&mesh, nullptr, &mesh}).length_mean, figures.length_mean, 1e-12);
}

TEST(MetricFigures, ArePlainWhereTurnsDoNotCount) {
  const RegionMesh mesh = tube(0.2, 1, 0.5, 0);
  const MetricFigures figures = measure({&mesh});
  EXPECT_NEAR(figures.length_mean, 0.5 * (2 + 2 * std::sin(0.1) / 0.5), 1e-12);
  EXPECT_EQ(figures.length_in_band, 0) << "0.4 and 2 target lengths";
}

TEST(MetricFigures, AreTheSameOnRanks) {
  const RegionMesh one = tube(0.2, 1, 0.5, 1), two = tube(0.3, 0.4, 0.6, 0);
  const MetricFigures whole = measure({&one, &two});
  test::run_on_ranks(2, [&](Ranks& ranks) {
    const bool is_first = ranks.rank() == 0;
    const MetricFigures figures =
        measure_metric({is_first ? &one : nullptr, is_first ? nullptr : &two}, 1, Progress(), ranks);
    EXPECT_EQ(figures.length_mean, whole.length_mean);
    EXPECT_EQ(figures.length_in_band, whole.length_in_band);
    EXPECT_EQ(figures.mean_sj, whole.mean_sj);
    EXPECT_EQ(figures.least_sj, whole.least_sj);
  });
}

TEST(MetricFigures, OfNothingAreZero) { EXPECT_EQ(measure({nullptr}).mean_sj, 0); }

}  // namespace
}  // namespace paver
