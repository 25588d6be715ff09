#include "cli/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace paver {
namespace {

TEST(ParseLength, TakesNumbersWithAndWithoutUnits) {
  EXPECT_DOUBLE_EQ(parse_length("30").value(), 30);
  EXPECT_DOUBLE_EQ(parse_length(" 30 mm ").value(), 30);
  EXPECT_DOUBLE_EQ(parse_length("1.5in").value(), 38.1);
  EXPECT_DOUBLE_EQ(parse_length("2 M").value(), 2000);
  EXPECT_DOUBLE_EQ(parse_length("+1e-3km").value(), 1000);
  EXPECT_DOUBLE_EQ(parse_length("-3").value(), -3) << "the range is checked with the other options";
}

TEST(ParseLength, RefusesWhatIsNoLength) {
  for (const char* text : {"", "five", "5 parsec", "5 5", "1,5", "5mm2", "mm", "--5", "0x10"}) {
    EXPECT_FALSE(parse_length(text)) << text;
  }
}

TEST(ParseFrequency, TakesHertzAndMultiples) {
  EXPECT_DOUBLE_EQ(parse_frequency("9e9").value(), 9e9);
  EXPECT_DOUBLE_EQ(parse_frequency("3GHz").value(), 3e9);
  EXPECT_DOUBLE_EQ(parse_frequency("300 MHz").value(), 3e8);
  EXPECT_DOUBLE_EQ(parse_frequency("1.5 khz").value(), 1500);
  EXPECT_FALSE(parse_frequency("3 mm"));
  EXPECT_TRUE(std::isnan(parse_frequency("nan").value()));
}

}  // namespace
}  // namespace paver
