// The least value of a function of one number.
#pragma once

namespace paver {

/// What sections leave of a range: the function is least between `low` and `high`; two places there and its values.
struct GoldenSection {
  double low, high, a, b, at_a, at_b;

  double middle() const { return 0.5 * (low + high); }
  double best() const { return at_a < at_b ? a : b; }
};

/// Golden sections of a range in which the function falls, then rises; one value each.
template <class Function>
GoldenSection golden_section(double low, double high, int rounds, const Function& value) {
  constexpr double golden = 0.6180339887498949;
  GoldenSection range{low, high, high - golden * (high - low), low + golden * (high - low), 0, 0};
  range.at_a = value(range.a), range.at_b = value(range.b);
  for (int i = 0; i < rounds; ++i) {
    if (range.at_a < range.at_b) {
      range.high = range.b, range.b = range.a, range.at_b = range.at_a;
      range.at_a = value(range.a = range.high - golden * (range.high - range.low));
    } else {
      range.low = range.a, range.a = range.b, range.at_a = range.at_b;
      range.at_b = value(range.b = range.low + golden * (range.high - range.low));
    }
  }
  return range;
}

}  // namespace paver
