// A sum that does not depend on the order of its terms, so that threads and ranks may add in any.
#pragma once

#include <array>
#include <cmath>

namespace paver {

/// Adds numbers in fixed point: multiples of 2^-60 units up to 2^32 units, at most 2^35 of them. Larger terms count as
/// 2^32 units, what is not a number as 0. The terms should be of the order of the unit: then rounding them costs less
/// than adding doubles would.
class ExactSum {
 public:
  /// `unit`: > 0; taken down to a power of two. The same for all that are added together.
  explicit ExactSum(double unit = 1) : exponent_(std::ilogb(unit)) { scale_ = std::ldexp(1.0, -exponent_); }

  void add(double term) {
    double units = term * scale_;
    if (!(std::fabs(units) < limit)) units = units > 0 ? limit : units < 0 ? -limit : 0;
    double high = units * half_step;
    long whole = static_cast<long>(high);
    sum_ += static_cast<Wide>(whole) * static_cast<long>(half_step) +
            static_cast<long>((high - static_cast<double>(whole)) * half_step);
  }
  void add(const ExactSum& other) { sum_ += other.sum_; }

  double total() const { return std::ldexp(static_cast<double>(sum_), exponent_ - 60); }

  static constexpr int part_count = 3;
  /// Parts to be added up among ranks, each on its own; 2^20 ranks at most.
  std::array<long, part_count> parts() const {
    return {static_cast<long>(sum_ & mask), static_cast<long>((sum_ >> 42) & mask), static_cast<long>(sum_ >> 84)};
  }
  void set_parts(const long* parts) {
    sum_ = ((static_cast<Wide>(parts[2]) * (mask + 1)) + parts[1]) * (mask + 1) + parts[0];
  }

 private:
  __extension__ typedef __int128 Wide;
  static constexpr double limit = 4294967296.0, half_step = 1 << 30;
  static constexpr Wide mask = (static_cast<Wide>(1) << 42) - 1;

  int exponent_;
  double scale_;
  Wide sum_ = 0;
};

}  // namespace paver
