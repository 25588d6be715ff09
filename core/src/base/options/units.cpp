// A number, then a unit of a list. std::from_chars, because it does not depend on the locale of the host program.
#include "paver/units.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

#include "base/trimmed.h"

namespace paver {
namespace {

/// A unit in lower case and its size in the base unit.
using Unit = std::pair<std::string_view, double>;

constexpr Unit length_units[] = {{"", 1},      {"mm", 1},       {"um", 1e-3}, {"\u00b5m", 1e-3}, {"\u03bcm", 1e-3},
                                 {"cm", 10},   {"m", 1000},     {"km", 1e6},  {"in", 25.4},      {"inch", 25.4},
                                 {"\"", 25.4}, {"mil", 0.0254}, {"ft", 304.8}};
constexpr Unit frequency_units[] = {{"", 1}, {"hz", 1}, {"khz", 1e3}, {"mhz", 1e6}, {"ghz", 1e9}, {"thz", 1e12}};
constexpr double degree = std::numbers::pi / 180;
constexpr Unit angle_units[] = {{"", degree}, {"deg", degree}, {"\u00b0", degree}, {"rad", 1}};
constexpr Unit no_units[] = {{"", 1}};

std::optional<double> parse_quantity(std::string text, std::span<const Unit> units) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  std::string_view left = trimmed(text);
  if (left.starts_with('+')) left.remove_prefix(1);
  double value = 0;
  const auto [rest, error] = std::from_chars(left.data(), left.data() + left.size(), value);
  if (error != std::errc()) return std::nullopt;
  const std::string_view unit = trimmed(left.substr(static_cast<std::size_t>(rest - left.data())));
  for (auto [name, size] : units) {
    if (name == unit) return value * size;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> parse_length(const std::string& text) { return parse_quantity(text, length_units); }

std::optional<double> parse_frequency(const std::string& text) { return parse_quantity(text, frequency_units); }

std::optional<double> parse_angle(const std::string& text) { return parse_quantity(text, angle_units); }

std::optional<double> parse_number(const std::string& text) { return parse_quantity(text, no_units); }

}  // namespace paver
