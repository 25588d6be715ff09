#include "paver/option_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "paver/error.h"

namespace paver {
namespace {

/// The message of the refusal; empty when the options are read.
std::string refusal(const std::vector<GivenOption>& given) {
  try {
    read_options(given);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option);
    return error.what();
  }
  return "";
}

TEST(ReadOptions, PutsEveryValueInItsField) {
  Options o = read_options({{"frequency", "3GHz"},
                            {"divisions", "8"},
                            {"eps_r", "2.5"},
                            {"mu_r", "1.5"},
                            {"max_turn", "90"},
                            {"gradation", "0.25"},
                            {"tip", "3"},
                            {"max_elements", "3e6"},
                            {"order", "1"},
                            {"elements", "all-quad"},
                            {"multilevel", "6"},
                            {"threads", "3"},
                            {"local", "Face3=2mm"},
                            {"local", "Edge1,Edge2=0.5"},
                            {"sew_tolerance", "10um"},
                            {"strict", "on"}});
  EXPECT_FALSE(o.size);
  EXPECT_EQ(o.frequency, 3e9);
  EXPECT_EQ(o.divisions, 8);
  EXPECT_EQ(o.eps_r, 2.5);
  EXPECT_EQ(o.mu_r, 1.5);
  EXPECT_DOUBLE_EQ(o.max_turn.value(), std::numbers::pi / 2);
  EXPECT_EQ(o.gradation, 0.25);
  EXPECT_EQ(o.tip, 3);
  EXPECT_EQ(o.max_elements, 3'000'000);
  EXPECT_EQ(o.order, 1);
  EXPECT_EQ(o.elements, Elements::all_quad);
  EXPECT_EQ(o.multilevel, 6);
  EXPECT_EQ(read_options({{"size", "1"}, {"multilevel", "auto"}}).multilevel, automatic_levels);
  EXPECT_EQ(read_options({{"size", "1"}, {"multilevel", "off"}}).multilevel, 0);
  EXPECT_EQ(o.threads, 3);
  ASSERT_EQ(o.local.size(), 3u);
  EXPECT_EQ(o.local[2].part, "Edge2");
  EXPECT_DOUBLE_EQ(o.sew_tolerance.value(), 0.01);
  EXPECT_TRUE(o.strict);
  EXPECT_NE(refusal({{"strict", "perhaps"}}), "");
  EXPECT_EQ(read_options({{"size", "2cm"}}).size, 20);
}

TEST(ReadOptions, DefaultsInTheTableAreThoseOfOptions) {
  Options defaults, read = read_options({{"frequency", "1"}});
  for (const OptionInfo& info : option_table()) {
    if (info.default_text.empty()) continue;
    Options again = read_options({{"frequency", "1"}, {info.name, info.default_text}});
    EXPECT_EQ(again.divisions, defaults.divisions) << info.name;
    EXPECT_EQ(again.order, defaults.order) << info.name;
    EXPECT_EQ(again.elements, defaults.elements) << info.name;
    EXPECT_EQ(again.multilevel, defaults.multilevel) << info.name;
    EXPECT_EQ(again.threads, defaults.threads) << info.name;
    EXPECT_EQ(again.gradation, defaults.gradation) << info.name;
    EXPECT_EQ(again.max_elements, defaults.max_elements) << info.name;
    EXPECT_EQ(again.eps_r, defaults.eps_r) << info.name;
    EXPECT_EQ(again.mu_r, defaults.mu_r) << info.name;
    EXPECT_EQ(again.strict, defaults.strict) << info.name;
  }
  EXPECT_EQ(read.gradation, defaults.gradation);
}

/// A form that shows options as numbers needs to know when 0 cannot stand for "none".
TEST(OptionTable, SaysWhereZeroIsAValue) {
  for (const OptionInfo& info : option_table()) {
    if (!info.default_text.empty()) continue;
    bool is_accepted = true;
    try {
      Options options = read_options({{info.name, "0"}});
      if (!options.size && !options.frequency) options.size = 1;
      check(options);
    } catch (const Error&) {
      is_accepted = false;
    }
    EXPECT_EQ(info.may_be_zero, is_accepted) << info.name;
  }
}

TEST(ReadOptions, RefusesWhatIsNotOfTheKindAndSaysHowToWriteIt) {
  EXPECT_EQ(refusal({{"size", "five"}}), "size is 'five'; write it like 30, 30mm, 1.5in or 2m.");
  EXPECT_EQ(refusal({{"size", "1"}, {"order", "1.5"}}), "order is '1.5'; write it like 2, a whole number.");
  EXPECT_EQ(refusal({{"size", "1"}, {"elements", "some"}}),
            "elements is 'some'; write it like quad-dominant, all-quad or all-triangle.");
  EXPECT_NE(refusal({{"size", "1"}, {"colour", "red"}}).find("'colour'"), std::string::npos);
  for (const OptionInfo& info : option_table()) {
    std::vector<GivenOption> given{{info.name, "?"}};
    if (!info.needs.empty()) given.insert(given.begin(), {info.needs, "1"});
    EXPECT_TRUE(refusal(given).starts_with(info.name + " is '?'; write it like ")) << info.name;
  }
}

TEST(ReadOptions, KnowsWhichOptionsGoTogether) {
  EXPECT_EQ(refusal({{"size", "1"}, {"frequency", "1"}}), "frequency excludes size; give only one of them.");
  EXPECT_EQ(refusal({{"size", "1"}, {"divisions", "1"}}), "divisions needs frequency; give both or neither.");
  EXPECT_EQ(refusal({{"divisions", "1"}, {"frequency", "1"}}), "");
}

}  // namespace
}  // namespace paver
