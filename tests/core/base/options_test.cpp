#include "paver/options.h"

#include <gtest/gtest.h>

#include <limits>

#include "paver/error.h"

namespace paver {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

Options sized() {
  Options options;
  options.size = 5;
  return options;
}

/// The message of the refusal; empty when the options pass.
std::string refusal(const Options& options) {
  try {
    check(options);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option);
    return error.what();
  }
  return "";
}

template <class Change>
std::string refusal_after(Change change) {
  Options options = sized();
  change(options);
  return refusal(options);
}

TEST(CheckOptions, NamesTheBadFieldAndItsValue) {
  for (double bad : {0.0, -1.0, nan, infinity}) {
    EXPECT_TRUE(refusal_after([=](Options& o) { o.size = bad; }).starts_with("size is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.divisions = bad; }).starts_with("divisions is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.eps_r = bad; }).starts_with("eps_r is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.mu_r = bad; }).starts_with("mu_r is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.max_turn = bad; }).starts_with("max_turn is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.gradation = bad; }).starts_with("gradation is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.tip = bad; }).starts_with("tip is ")) << bad;
    EXPECT_TRUE(refusal_after([=](Options& o) { o.chord_error = bad; }).starts_with("chord_error is ")) << bad;
  }
  EXPECT_EQ(refusal_after([](Options& o) { o.order = 7; }), "order is 7; it must be from 1 to 2.");
  EXPECT_EQ(refusal_after([](Options& o) { o.threads = -2; }), "threads is -2; it must be from 0 to 1024.");
  EXPECT_EQ(refusal_after([](Options& o) { o.multilevel = 3; }), "multilevel is 3; it must be from 4 to 8.");
  EXPECT_EQ(refusal_after([](Options& o) { o.multilevel = automatic_levels; }), "");
  EXPECT_EQ(refusal_after([](Options& o) { o.max_elements = 0; }), "max_elements is 0; it must be at least 1.");
  EXPECT_NE(refusal_after([](Options& o) { o.sew_tolerance = -1; }), "");
  EXPECT_EQ(refusal_after([](Options& o) { o.sew_tolerance = 0; }), "");
}

TEST(CheckOptions, LengthsAndTurnsAreOfASizeThatCanBeReckonedWith) {
  EXPECT_EQ(refusal_after([](Options& o) { o.size = 1e-300; }), "size is 1e-300 mm; it must be from 1e-09 to 1e+15.");
  EXPECT_EQ(refusal_after([](Options& o) { o.size = 1e300; }), "size is 1e+300 mm; it must be from 1e-09 to 1e+15.");
  EXPECT_NE(refusal_after([](Options& o) { o.chord_error = 1e-300; }), "");
  EXPECT_NE(refusal_after([](Options& o) { o.max_turn = 1e-300; }), "");
}

TEST(CheckOptions, LocalLengthsArePositiveAndForPartsOfModels) {
  auto of = [](LocalSize local) { return refusal_after([=](Options& o) { o.local = {local}; }); };
  EXPECT_EQ(of({"Face3", 1.0}), "");
  EXPECT_EQ(of({"Face3", -2.0}), "local Face3 is -2 mm; it must be a finite number above 0.");
  EXPECT_EQ(of({"Rim", 1.0}), "local names 'Rim', which is no part of a model; write Face3, Edge5, Vertex2 or Solid1.");
  EXPECT_EQ(of({"Solid1", std::nullopt, 4.0}),
            "local Solid1 has a medium, which needs frequency; set frequency, or give a length instead.");
  EXPECT_EQ(of({"Solid1", std::nullopt, 0.0}), "local Solid1 eps_r is 0; it must be a finite number above 0.");
}

TEST(CheckOptions, WantsEitherSizeOrFrequency) {
  EXPECT_EQ(refusal(sized()), "");
  EXPECT_NE(refusal(Options()), "");
  EXPECT_NE(refusal_after([](Options& o) { o.frequency = 1e9; }), "");
  Options tiny;
  tiny.frequency = std::numeric_limits<double>::denorm_min();
  EXPECT_NE(refusal(tiny), "") << "the target length overflows";
}

TEST(TargetLength, FollowsFromTheWavelengthInTheMedium) {
  Options options;
  options.frequency = 3e9;
  EXPECT_NEAR(target_length(options), 9.9930819, 1e-6);
  options.eps_r = 4;
  options.divisions = 5;
  EXPECT_NEAR(target_length(options), 9.9930819, 1e-6);
  EXPECT_EQ(target_length(sized()), 5);
}

}  // namespace
}  // namespace paver
