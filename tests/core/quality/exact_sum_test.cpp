#include "quality/exact_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace paver {
namespace {

std::vector<double> numbers() {
  std::mt19937_64 random(3);
  std::vector<double> values;
  for (int i = 0; i < 5000; ++i) values.push_back(std::ldexp(static_cast<double>(random() >> 11), -50 - i % 12) - 3);
  return values;
}

double total(const std::vector<double>& values, double unit) {
  ExactSum sum(unit);
  for (double value : values) sum.add(value);
  return sum.total();
}

TEST(ExactSum, DoesNotDependOnOrderOrPartition) {
  std::vector<double> values = numbers();
  for (double unit : {1e-3, 1.0, 77.0}) {
    double whole = total(values, unit);
    std::reverse(values.begin(), values.end());
    EXPECT_EQ(total(values, unit), whole);
    std::sort(values.begin(), values.end());
    EXPECT_EQ(total(values, unit), whole);
    std::array<long, ExactSum::part_count> added{};
    for (std::size_t part = 0; part < 7; ++part) {
      ExactSum sum(unit);
      for (std::size_t i = part; i < values.size(); i += 7) sum.add(values[i]);
      for (std::size_t k = 0; k < added.size(); ++k) added[k] += sum.parts()[k];
    }
    ExactSum together(unit);
    together.set_parts(added.data());
    EXPECT_EQ(together.total(), whole);
  }
}

TEST(ExactSum, IsAsCloseAsASumOfLongDoubles) {
  std::vector<double> values = numbers();
  long double sum = 0;
  for (double value : values) sum += value;
  EXPECT_NEAR(total(values, 1), static_cast<double>(sum), 1e-12);
  EXPECT_EQ(total({0.1, 0.2, -0.1, -0.2}, 1), 0);
  EXPECT_EQ(total({}, 5), 0);
  EXPECT_EQ(total({-3.5}, 5), -3.5);
}

TEST(ExactSum, TakesWhatIsNoNumberAsNothingAndHasALimit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(total({1, std::numeric_limits<double>::quiet_NaN(), 2}, 1), 3);
  EXPECT_EQ(total({infinity, infinity}, 1), std::ldexp(1.0, 33));
  EXPECT_EQ(total({-infinity}, 2), -std::ldexp(1.0, 33));
}

}  // namespace
}  // namespace paver
