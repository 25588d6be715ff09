// Checks the options of a run and derives the target length from them.
//
// The comparisons are written so that NaN fails every one of them.
#include "paver/options.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "paver/error.h"

namespace paver {
namespace {

constexpr double light_speed_mm_per_s = 299'792'458e3;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_threads = 1024;

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorCode::bad_option, text); }

void check_positive(const char* name, double value, const char* unit = "") {
  if (!(value > 0 && value < infinity)) {
    refuse(fmt::format("{} is {:.6g}{}; it must be a finite number above 0.", name, value, unit));
  }
}

void check_range(const char* name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {
    refuse(fmt::format("{} is {:.6g}; it must be from {:.6g} to {:.6g}.", name, value, low, high));
  }
}

void check_target(const Options& options) {
  if (options.size && options.frequency) refuse("Both size and frequency are set; give only one of them.");
  if (!options.size && !options.frequency) refuse("No target length: set size, or frequency and divisions.");
  if (options.size) check_positive("size", *options.size, " mm");
  if (options.frequency) check_positive("frequency", *options.frequency, " Hz");
  check_positive("divisions", options.divisions);
  check_positive("eps_r", options.eps_r);
  check_positive("mu_r", options.mu_r);
  double h = target_length(options);
  if (!(h > 0 && h < infinity)) {
    refuse(fmt::format("The target length that follows from the frequency is {:.6g} mm; it must be finite and above 0.",
                       h));
  }
}

}  // namespace

const char* elements_name(Elements elements) {
  switch (elements) {
    case Elements::all_quad:
      return "all-quad";
    case Elements::all_triangle:
      return "all-triangle";
    case Elements::quad_dominant:
      break;
  }
  return "quad-dominant";
}

void check(const Options& options) {
  check_target(options);
  check_range("order", options.order, 1, 2);
  check_range("threads", options.threads, 0, most_threads);
  check_range("gradation", options.gradation, 0.05, 2);
  if (options.max_turn) {
    double degrees = *options.max_turn * 180 / std::numbers::pi;
    if (!(degrees > 0 && degrees <= 90.000001)) {
      refuse(fmt::format("max_turn is {:.6g} degrees; it must be above 0 and at most 90 degrees.", degrees));
    }
  }
  if (options.max_elements < 1) {
    refuse(fmt::format("max_elements is {}; it must be at least 1.", options.max_elements));
  }
  if (options.sew_tolerance && !(*options.sew_tolerance >= 0 && *options.sew_tolerance < infinity)) {
    refuse(fmt::format("sew_tolerance is {:.6g} mm; it must be 0 (never sew) or a finite number above 0.",
                       *options.sew_tolerance));
  }
}

double target_length(const Options& options) {
  if (options.size) return *options.size;
  double frequency = options.frequency.value_or(0);
  return light_speed_mm_per_s / (frequency * std::sqrt(options.eps_r * options.mu_r) * options.divisions);
}

}  // namespace paver
