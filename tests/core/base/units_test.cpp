#include "paver/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

TEST(ParseAngle, TakesDegreesUnlessARadIsGiven) {
  EXPECT_DOUBLE_EQ(parse_angle("180").value(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_angle("90 deg").value(), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(parse_angle("90\u00b0").value(), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(parse_angle("0.5rad").value(), 0.5);
  EXPECT_FALSE(parse_angle("5 mm"));
}

TEST(ParseNumber, TakesNoUnit) {
  EXPECT_EQ(parse_number("2.5").value(), 2.5);
  EXPECT_EQ(parse_number("0.1").value(), 0.1);
  EXPECT_FALSE(parse_number("2 mm"));
}

}  // namespace
}  // namespace paver
