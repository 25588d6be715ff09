#include "boundary/edge_metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fake_model.h"

namespace paver {
namespace {

SizeField size_of(double h, double turn_limit = 0.8) {
  SizeField size;
  size.h = h;
  size.turn_limit = turn_limit;
  return size;
}

Edge edge_on(std::shared_ptr<const Curve> curve, double t0, double t1, bool is_closed) {
  Edge edge;
  edge.curve = std::move(curve);
  edge.t0 = t0;
  edge.t1 = t1;
  edge.start = 0;
  edge.end = is_closed ? 0 : 1;
  return edge;
}

TEST(EdgeMetric, AStraightEdgeIsItsLengthOverH) {
  Edge edge = edge_on(std::make_shared<fake::Line>(Vec3{0, 0, 0}, Vec3{3, 4, 0}), 0, 1, false);
  EdgeMetric metric(edge, size_of(0.5));
  EXPECT_NEAR(metric.length(), 5, 1e-14);
  EXPECT_NEAR(metric.weight(), 10, 1e-13);
  EXPECT_DOUBLE_EQ(metric.turn(), 0);
  EXPECT_NEAR(metric.parameter_at_length(metric.length_at_weight(2.5)), 0.25, 1e-14);
}

TEST(EdgeMetric, ACircleTurnsOnceAndIsCutByItsCurvature) {
  Edge edge = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 2, 2), 0, 2 * fake::pi, true);
  EdgeMetric metric(edge, size_of(100, 0.5));
  EXPECT_NEAR(metric.length(), 4 * fake::pi, 1e-10);
  EXPECT_NEAR(metric.turn(), 2 * fake::pi, 1e-10);
  EXPECT_NEAR(metric.weight(), 4 * fake::pi, 1e-10);  // h = 0.5 * 2
}

TEST(EdgeMetric, ArcLengthOfAnEllipseIsThatOfTheCompleteEllipticIntegral) {
  Edge edge = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 2, 1), 0, 2 * fake::pi, true);
  EdgeMetric metric(edge, size_of(0.1));
  EXPECT_NEAR(metric.length(), 9.688448220547675, 1e-7);
  EXPECT_NEAR(metric.parameter_at_length(0.25 * metric.length()), 0.5 * fake::pi, 1e-8);
}

/// From (0, 0) along the x axis to x = 1, where it turns by `angle` within about 1e-4.
class Hook : public Curve {
 public:
  explicit Hook(double angle) : slope_(std::tan(angle)) {}
  Vec3 point(double t) const override { return {t, slope_ * width * std::log1p(std::exp(share(t))), 0}; }
  CurveSlope slope(double t) const override { return {point(t), {1, slope_ / (1 + std::exp(-share(t))), 0}}; }
  CurveJet jet(double t) const override {
    const double rise = 1 / (1 + std::exp(-share(t)));
    return {slope(t), {0, slope_ * rise * (1 - rise) / width, 0}};
  }

 private:
  static constexpr double width = 1e-5;
  static double share(double t) { return (t - 1) / width + 8; }
  double slope_;
};

// Curves of intersection end so, by rounding.
TEST(EdgeMetric, ABendThatTurnsLittleInAllDoesNotMakeSmallIntervals) {
  constexpr double limit = 0.8;
  auto weight = [&](double angle) {
    return EdgeMetric(edge_on(std::make_shared<Hook>(angle), 0, 1, false), size_of(0.25, limit)).weight();
  };
  EXPECT_NEAR(weight(0.5 * limit), 4, 0.01);
  EXPECT_GT(weight(1.5 * limit), 8);
}

TEST(EdgeMetric, TellsHowManyIntervalsTheTurnNeeds) {
  Edge edge = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 1, 1), 0, fake::pi, false);
  EdgeMetric metric(edge, size_of(100, fake::pi / 4));
  EXPECT_FALSE(metric.turns_within(3));
  EXPECT_TRUE(metric.turns_within(4));
}

TEST(EdgeMetric, AnEdgeMuchShorterThanHMayTurnMore) {
  SizeField size = size_of(10, fake::pi / 4);
  size.short_turn_limit = fake::pi / 2;
  Edge tiny = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 1, 1), 0, fake::pi, false);
  EdgeMetric tiny_metric(tiny, size);
  EXPECT_FALSE(tiny_metric.turns_within(1));
  EXPECT_TRUE(tiny_metric.turns_within(2)) << "a quarter turn on 1.6 of 10";
  EXPECT_NEAR(tiny_metric.weight(), 2, 1e-9);
  Edge middling = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 6, 6), 0, fake::pi, false);
  EdgeMetric middling_metric(middling, size);
  EXPECT_FALSE(middling_metric.turns_within(2)) << "a quarter turn on 9.4 of 10";
  EXPECT_TRUE(middling_metric.turns_within(3));
}

TEST(EdgeMetric, AnEdgeWithOneFaceOnBothSidesMayNot) {
  SizeField size = size_of(10, fake::pi / 4);
  size.short_turn_limit = fake::pi / 2;
  Edge seam = edge_on(std::make_shared<fake::Ellipse>(Vec3{}, 1, 1), 0, fake::pi, false);
  seam.faces = {0, 0};
  const EdgeMetric metric(seam, size);
  EXPECT_FALSE(metric.turns_within(3));
  EXPECT_TRUE(metric.turns_within(4));
}

// Two straight pieces with a jump of the tangent at t = 0.3.
class BentLine : public Curve {
 public:
  Vec3 point(double t) const override { return t < 0.3 ? Vec3{t, 0, 0} : Vec3{0.3, t - 0.3, 0}; }
  CurveSlope slope(double t) const override { return {point(t), t < 0.3 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}}; }
  CurveJet jet(double t) const override { return {slope(t)}; }
};

TEST(EdgeMetric, AKinkTakesANode) {
  Edge edge = edge_on(std::make_shared<BentLine>(), 0, 1, false);
  EdgeMetric metric(edge, size_of(0.25, 0.7));
  EXPECT_EQ(metric.kink_count(), 1);
  EXPECT_NEAR(metric.length(), 1, 1e-9);
  EXPECT_NEAR(metric.turn(), fake::pi / 2, 1e-12);
  EXPECT_NEAR(metric.smooth_turn(), 0, 1e-12);
  EXPECT_FALSE(metric.turns_within(1));
  EXPECT_TRUE(metric.turns_within(2));
  std::vector<double> lengths = metric.node_lengths(4);
  ASSERT_EQ(lengths.size(), 5u);
  const std::vector<double> expected = {0, 0.3, 0.3 + 0.7 / 3, 0.3 + 1.4 / 3, 1};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(lengths[i], expected[i], 1e-6);
  EXPECT_NEAR(metric.parameter_at_length(lengths[1]), 0.3, 1e-12);
  EXPECT_EQ(metric.node_lengths(1), (std::vector<double>{0, metric.length()}));
}

// Out along x and back again; at the turn the curve stands still.
class FoldedLine : public Curve {
 public:
  Vec3 point(double t) const override { return {t * (2 - t), 0, 0}; }
  CurveSlope slope(double t) const override { return {point(t), {2 - 2 * t, 0, 0}}; }
  CurveJet jet(double t) const override { return {slope(t), {-2, 0, 0}}; }
};

TEST(EdgeMetric, AFoldTakesANodeToo) {
  Edge edge = edge_on(std::make_shared<FoldedLine>(), 0, 2, true);
  EdgeMetric metric(edge, size_of(1));
  ASSERT_EQ(metric.kink_count(), 1);
  EXPECT_NEAR(metric.length(), 2, 1e-6);
  EXPECT_NEAR(edge.curve->point(metric.parameter_at_length(metric.node_lengths(4)[2])).x, 1, 1e-9);
}

TEST(EdgeMetric, AKinkAtTheEndOfAnEdgeIsNoTurnOfIt) {
  Edge edge = edge_on(std::make_shared<BentLine>(), 0, 0.3, false);
  EdgeMetric metric(edge, size_of(0.25));
  EXPECT_EQ(metric.kink_count(), 0);
  EXPECT_NEAR(metric.turn(), 0, 1e-12);
}

// Along x, a quarter of a circle, along y; t is the length, the arc begins at t = 1.
class RoundedCorner : public Curve {
 public:
  explicit RoundedCorner(double radius) : radius_(radius) {}
  double arc() const { return 0.5 * fake::pi * radius_; }
  Vec3 point(double t) const override {
    const double a = angle(t);
    const Vec3 on_arc{1 + radius_ * std::sin(a), radius_ * (1 - std::cos(a)), 0};
    return on_arc + Vec3{std::min(t - 1, 0.0), std::max(t - 1 - arc(), 0.0), 0};
  }
  CurveSlope slope(double t) const override { return {point(t), {std::cos(angle(t)), std::sin(angle(t)), 0}}; }
  CurveJet jet(double t) const override {
    const CurveSlope at = slope(t);
    const bool is_on_arc = t > 1 && t < 1 + arc();
    return {at, is_on_arc ? (1 / radius_) * Vec3{-at.t.y, at.t.x, 0} : Vec3{}};
  }

 private:
  double angle(double t) const { return std::clamp(t - 1, 0.0, arc()) / radius_; }
  double radius_;
};

SizeField size_with_small_bends(double share) {
  SizeField size = size_of(0.5, fake::pi / 4);
  size.short_turn_limit = 75 * fake::pi / 180;
  size.small_bend = share;
  return size;
}

TEST(EdgeMetric, ABendThatIsSmallAgainstHIsAKinkInItsMiddle) {
  const auto corner = std::make_shared<RoundedCorner>(0.01);
  const Edge edge = edge_on(corner, 0, 2 + corner->arc(), false);
  const SizeField size = size_with_small_bends(0.1);
  const EdgeMetric metric(edge, size);
  ASSERT_EQ(metric.kink_count(), 1);
  EXPECT_NEAR(metric.turn(), fake::pi / 2, 0.02);
  EXPECT_NEAR(metric.smooth_turn(), 0, 0.02);
  EXPECT_NEAR(metric.weight(), 4, 0.1);
  const std::vector<double> lengths = metric.node_lengths(4);
  EXPECT_NEAR(lengths[2], 1 + 0.5 * corner->arc(), 1e-3);
  for (double length : lengths) EXPECT_NEAR(metric.parameter_at_length(length), length, 1e-9);
  EXPECT_TRUE(metric.turns_within(4));
  EXPECT_GT(EdgeMetric(edge, size_with_small_bends(0)).weight(), 8);
}

TEST(EdgeMetric, ABendThatIsNotSmallStaysOne) {
  for (double radius : {0.05, 0.2}) {
    const auto corner = std::make_shared<RoundedCorner>(radius);
    const EdgeMetric metric(edge_on(corner, 0, 2 + corner->arc(), false), size_with_small_bends(0.1));
    EXPECT_EQ(metric.kink_count(), 0);
    EXPECT_NEAR(metric.smooth_turn(), fake::pi / 2, 1e-9);
  }
}

TEST(EdgeMetric, ASmallBendAtTheEndOfAnEdgeIsNoTurnOfIt) {
  const auto corner = std::make_shared<RoundedCorner>(0.01);
  for (auto [from, to] : {std::array{0.0, 1.01 + corner->arc()}, std::array{0.99, 2.0}}) {
    const EdgeMetric metric(edge_on(corner, from, to, false), size_with_small_bends(0.1));
    EXPECT_EQ(metric.kink_count(), 0);
    EXPECT_NEAR(metric.turn(), 0, 0.02);
    EXPECT_NEAR(metric.weight(), 2, 0.1);
  }
}

TEST(EdgeMetric, ASmallCircleHasNoKink) {
  for (double radius : {0.005, 0.02, 0.1}) {
    const EdgeMetric metric(edge_on(std::make_shared<fake::Ellipse>(Vec3{}, radius, radius), 0, 2 * fake::pi, true),
                            size_with_small_bends(0.1));
    EXPECT_EQ(metric.kink_count(), 0) << radius;
    EXPECT_NEAR(metric.turn(), 2 * fake::pi, 1e-9) << radius;
  }
}

TEST(EdgeMetric, AnEdgeWithoutLengthHasOneRowOfNothing) {
  Edge edge = edge_on(std::make_shared<fake::Line>(Vec3{1, 1, 1}, Vec3{1, 1, 1}), 0, 1, false);
  EdgeMetric metric(edge, size_of(1));
  EXPECT_DOUBLE_EQ(metric.length(), 0);
  EXPECT_DOUBLE_EQ(metric.weight(), 0);
  EXPECT_TRUE(std::isfinite(metric.parameter_at_length(0)));
}

}  // namespace
}  // namespace paver
