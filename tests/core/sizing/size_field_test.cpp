#include "sizing/size_field.h"

#include <gtest/gtest.h>

#include "support/fake_model.h"

namespace paver {
namespace {

Options with_size(double h) {
  Options options;
  options.size = h;
  return options;
}

SizeField size_of(const Model& model, const Options& options) {
  Progress progress;
  return build_size_field(model, options, progress);
}

TEST(FaceSize, IsBilinearInsideItsBoxAndClampedOutside) {
  FaceSize size(9, {{0, 0}, {2, 2}}, 3, {1, 2, 3, 5, 6, 7, 9, 10, 11});
  EXPECT_DOUBLE_EQ(size.by_curvature({0, 0}), 1);
  EXPECT_DOUBLE_EQ(size.by_curvature({2, 1}), 7);
  EXPECT_DOUBLE_EQ(size.by_curvature({0.5, 0}), 1.5);
  EXPECT_DOUBLE_EQ(size.by_curvature({1, 0.5}), 4);
  EXPECT_DOUBLE_EQ(size.by_curvature({-5, -5}), 1);
  EXPECT_DOUBLE_EQ(size.by_curvature({50, 0}), 3);
  EXPECT_DOUBLE_EQ(size.by_curvature({std::nan(""), 0}), 1);
}

TEST(FaceSize, KeepsItsShorterLengthsWhereItIsBounded) {
  const FaceSize size = FaceSize(9, {{0, 0}, {2, 2}}, 2, {1, 4, 6, 9}).at_most(5);
  EXPECT_DOUBLE_EQ(size.own(), 5);
  EXPECT_DOUBLE_EQ(size.by_curvature({0, 0}), 1);
  EXPECT_DOUBLE_EQ(size.by_curvature({2, 0}), 4);
  EXPECT_DOUBLE_EQ(size.by_curvature({2, 2}), 5);
}

TEST(BuildSizeField, FlatFacesHaveTheTargetLengthEverywhere) {
  SizeField field = size_of(fake::box(1, 2, 3), with_size(0.25));
  ASSERT_EQ(field.faces.size(), 6u);
  for (const FaceSize& face : field.faces) EXPECT_DOUBLE_EQ(face.by_curvature({0.3, 0.4}), 0.25);
}

TEST(BuildSizeField, NoFaceHasALengthAboveItsOwnSize) {
  SizeField box = size_of(fake::box(1, 2, 3), with_size(1e6));
  for (const FaceSize& face : box.faces) {
    EXPECT_GE(face.own(), std::sqrt(5.0) - 1e-12);
    EXPECT_LE(face.own(), std::sqrt(13.0) + 1e-12);
  }
  EXPECT_DOUBLE_EQ(box.h, 1e6);
  SizeField ball = size_of(fake::ball(3), with_size(1e6));
  EXPECT_NEAR(ball.faces[0].own(), 6 * std::sqrt(3.0), 0.1);
  EXPECT_LT(ball.faces[0].by_curvature({1, 0.2}), 3);  // it turns all the way round
}

// Where a surface bends one way only, rows of long elements follow it: their sides may turn 2.5 times the limit.
TEST(SizeField, AShortEdgeStaysAsCloseToItsCurveAsALongOne) {
  SizeField field = size_of(fake::box(1, 2, 3), with_size(2));
  const TurnLimit limit = field.turn_limit_of({});
  const double sagitta = 2 * field.turn_limit / 8;  // of an edge of length h that turns by the limit
  EXPECT_DOUBLE_EQ(limit.longest_edge(0), 2);
  EXPECT_DOUBLE_EQ(limit.longest_edge(0.5 * field.turn_limit), 2);
  for (double radius : {2.0, 1.5, 1.0}) {
    double length = limit.longest_edge(1 / radius);
    EXPECT_NEAR(length * length / (8 * radius), sagitta, 1e-12);
    EXPECT_TRUE(limit.may_turn(0.999 * length / radius, length));
    EXPECT_FALSE(limit.may_turn(1.001 * length / radius, length));
  }
  EXPECT_NEAR(limit.longest_edge(100), field.short_turn_limit / 100, 1e-15);
  EXPECT_FALSE(limit.may_turn(1.01 * field.short_turn_limit, 1e-6));
}

TEST(SizeField, ALimitThatTheUserSetsHoldsForShortEdgesToo) {
  Options options = with_size(2);
  options.max_turn = 0.5;
  SizeField field = size_of(fake::box(1, 2, 3), options);
  const TurnLimit limit = field.turn_limit_of({});
  EXPECT_DOUBLE_EQ(limit.longest_edge(1), 0.5);
  EXPECT_FALSE(limit.may_turn(0.51, 1e-6));
}

TEST(BuildSizeField, OnACylinderThatTurnsMuchTurnsCountAndTheLengthStays) {
  Options options = with_size(6);
  options.max_turn = 0.2;
  SizeField field = size_of(fake::tube(4, 20), options);
  EXPECT_DOUBLE_EQ(field.faces[0].turn_weight(), 1 / 0.2);
  ASSERT_NE(field.faces[0].normals(), nullptr);
  for (Vec2 uv : {Vec2{0, 0}, Vec2{1, 7}, Vec2{6, 20}}) EXPECT_DOUBLE_EQ(field.faces[0].by_curvature(uv), 6);
  const double stretch = std::sqrt(1 + std::pow(6 / (0.2 * 4), 2));
  EXPECT_NEAR(field.predicted[0], 2 * fake::pi * 4 * 20 / 36 * stretch, 0.1 * field.predicted[0]);
}

TEST(BuildSizeField, AnAspectBoundsHowFarTurnsStretchLengths) {
  Options options = with_size(6);
  options.max_turn = 0.1;
  for (double radius : {1.0, 4.0, 20.0}) {
    const Model tube = fake::tube(radius, 100);
    for (double aspect : {1.5, 3.0, 8.0}) {
      options.aspect = aspect;
      const SizeField field = size_of(tube, options);
      const NormalTable* normals = field.faces[0].normals();
      ASSERT_NE(normals, nullptr) << radius << " " << aspect;
      const double weight = field.faces[0].own() * field.faces[0].turn_weight(), step = 0.01;
      for (double u = 0; u < 2 * fake::pi; u += 0.37) {
        const double turn = norm(normals->at({u + step, 5}) - normals->at({u, 5})) / (step * radius);
        EXPECT_LE(std::hypot(1, weight * turn), aspect * 1.001) << radius << " " << aspect << " " << u;
      }
    }
    options.aspect = 1;
    EXPECT_EQ(size_of(tube, options).faces[0].normals(), nullptr);
  }
}

TEST(BuildSizeField, OnOneThatTurnsLittleTheyDoNot) {
  SizeField field = size_of(fake::tube(4, 20), with_size(0.5));
  EXPECT_EQ(field.faces[0].turn_weight(), 0);
  EXPECT_EQ(field.faces[0].normals(), nullptr);
  for (std::size_t e = 0; e < 10; ++e) EXPECT_TRUE(field.turning_sides(e).empty());
}

TEST(BuildSizeField, ASphereIsLimitedAtItsPolesAsElsewhere) {
  Options options = with_size(6);
  options.max_turn = 0.5;
  SizeField field = size_of(fake::ball(4), options);
  for (Vec2 uv : {Vec2{0, -fake::pi / 2}, Vec2{3, fake::pi / 2}, Vec2{1, 0.2}}) {
    EXPECT_NEAR(field.faces[0].by_curvature(uv), 2, 1e-9);
  }
}

TEST(BuildSizeField, ATinyTubeAsksForABoundedNumberOfElements) {
  SizeField field = size_of(fake::tube(0.001, 1), with_size(1));
  EXPECT_LT(field.predicted[0], 20);
  EXPECT_FALSE(field.turning_sides(0).empty() && field.turning_sides(1).empty());
}

TEST(BuildSizeField, TooManyElementsAreRefusedWithNumberLengthAndLimit) {
  Options options = with_size(1e-9);
  try {
    size_of(fake::box(1, 1, 1), options);
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_many_elements);
    std::string text = error.what();
    EXPECT_NE(text.find("6e+18"), std::string::npos) << text;
    EXPECT_NE(text.find("1e-09"), std::string::npos) << text;
    EXPECT_NE(text.find("2000000"), std::string::npos) << text;
    EXPECT_NE(text.find("max_elements"), std::string::npos) << text;
  }
}

TEST(BuildSizeField, ALongThinStripCountsByItsLength) {
  Options options = with_size(1);
  options.max_elements = 1000;
  Model strip = fake::polygon({{0, 0, 0}, {1e5, 0, 0}, {1e5, 1e-3, 0}, {0, 1e-3, 0}});
  EXPECT_THROW(size_of(strip, options), Error);
}

TEST(BuildSizeField, CancelStopsIt) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(build_size_field(fake::box(1, 1, 1), with_size(1), progress), Error);
}

}  // namespace
}  // namespace paver
