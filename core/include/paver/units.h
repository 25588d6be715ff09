// Numbers with units as users write them: "30 mm", "1.5in", "3GHz". Case, and blanks around number and unit, do not
// matter. Nothing is given back for a text that is not a number with a unit of the list.
#pragma once

#include <optional>
#include <string>

namespace paver {

/// Millimetres. Units: mm, um, cm, m, km, in (inch, "), mil, ft; a plain number is millimetres.
std::optional<double> parse_length(const std::string& text);

/// Hertz. Units: Hz, kHz, MHz, GHz, THz; a plain number is hertz.
std::optional<double> parse_frequency(const std::string& text);

/// Radians. Units: deg, rad; a plain number is degrees.
std::optional<double> parse_angle(const std::string& text);

/// A number without a unit.
std::optional<double> parse_number(const std::string& text);

}  // namespace paver
