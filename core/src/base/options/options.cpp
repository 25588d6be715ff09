// Checks the options of a run and derives the target length from them.
//
// The comparisons are written so that NaN fails every one of them.
#include "paver/options.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/local_parts.h"
#include "base/options/named_options.h"
#include "paver/error.h"

namespace paver {
namespace {

constexpr double light_speed_mm_per_s = 299'792'458e3;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_threads = 1024, most_ranks = 4096;
constexpr double least_length = 1e-9, most_length = 1e15;  // mm: beyond them squares of coordinates lose their digits
constexpr double least_turn = 0.01;                        // degrees

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorCode::bad_option, text); }

void check_positive(const std::string& name, double value, const char* unit = "") {
  if (!(value > 0 && value < infinity)) {
    refuse(fmt::format("{} is {:.6g}{}; it must be a finite number above 0.", name, value, unit));
  }
}

void check_range(const std::string& name, double value, double low, double high, const char* unit = "") {
  if (!(value >= low && value <= high)) {
    refuse(fmt::format("{} is {:.6g}{}; it must be from {:.6g} to {:.6g}.", name, value, unit, low, high));
  }
}

void check_length(const std::string& name, double value) {
  check_positive(name, value, " mm");
  check_range(name, value, least_length, most_length, " mm");
}

void check_target(const Options& options) {
  if (options.size && options.frequency) refuse("Both size and frequency are set; give only one of them.");
  if (!options.size && !options.frequency) refuse("No target length: set size, or frequency and divisions.");
  if (options.size) check_length("size", *options.size);
  if (options.frequency) check_positive("frequency", *options.frequency, " Hz");
  check_positive("divisions", options.divisions);
  check_positive("eps_r", options.eps_r);
  check_positive("mu_r", options.mu_r);
  check_length("The target length that follows from the frequency", target_length(options));
}

void check_local(const Options& options, const LocalSize& local) {
  if (!parse_part(local.part))
    refuse(fmt::format("local names '{}', which is no part of a model; write Face3, Edge5, Vertex2 or Solid1.",
                       local.part));
  const std::string name = "local " + local.part;
  if (local.size) check_length(name, *local.size);
  check_positive(name + " eps_r", local.eps_r);
  check_positive(name + " mu_r", local.mu_r);
  if (!local.size && !options.frequency)
    refuse(fmt::format("{} has a medium, which needs frequency; set frequency, or give a length instead.", name));
  check_length(name + ": the length that follows from the frequency", local_length(options, local));
}

double length_in_medium(const Options& options, double eps_r, double mu_r) {
  double frequency = options.frequency.value_or(0);
  return light_speed_mm_per_s / (frequency * std::sqrt(eps_r * mu_r) * options.divisions);
}

}  // namespace

const char* elements_name(Elements elements) {
  static constexpr const char* names[] = {"quad-dominant", "all-quad", "all-triangle"};
  static_assert(std::size(names) == static_cast<std::size_t>(Elements::all_triangle) + 1);
  return names[static_cast<std::size_t>(elements)];
}

const char* connect_name(Connect connect) {
  static constexpr const char* names[] = {"imprint", "union", "none"};
  static_assert(std::size(names) == static_cast<std::size_t>(Connect::none) + 1);
  return names[static_cast<std::size_t>(connect)];
}

void check(const Options& options) {
  check_target(options);
  check_range("order", options.order, 1, 2);
  if (options.multilevel != 0 && options.multilevel != automatic_levels) {
    check_range("multilevel", options.multilevel, 4, 8);
  }
  check_range("threads", options.threads, 0, most_threads);
  check_range("ranks", options.ranks, 0, most_ranks);
  check_range("aspect", options.aspect, 1, 64);
  check_range("gradation", options.gradation, 0.05, 2);
  check_range("tip", options.tip, 1, 64);
  check_range("grade_edges", options.grade_edges, 1, 64);
  check_range("gap_elements", options.gap_elements, 1, 8);
  check_range("merge", options.merge, 0, 0.5);
  check_range("merge_width", options.merge_width, 0, 0.5);
  if (options.max_turn)
    check_range("max_turn", *options.max_turn * 180 / std::numbers::pi, least_turn, 90.000001, " degrees");
  if (options.chord_error) check_length("chord_error", *options.chord_error);
  if (options.max_elements < 1) {
    refuse(fmt::format("max_elements is {}; it must be at least 1.", options.max_elements));
  }
  if (options.sew_tolerance && !(*options.sew_tolerance >= 0 && *options.sew_tolerance < infinity)) {
    refuse(fmt::format("sew_tolerance is {:.6g} mm; it must be 0 (never sew) or a finite number above 0.",
                       *options.sew_tolerance));
  }
  for (const LocalSize& local : options.local) check_local(options, local);
  check_named(options);
}

double target_length(const Options& options) {
  if (options.size) return *options.size;
  return length_in_medium(options, options.eps_r, options.mu_r);
}

double local_length(const Options& options, const LocalSize& local) {
  if (local.size) return *local.size;
  return length_in_medium(options, local.eps_r, local.mu_r);
}

}  // namespace paver
