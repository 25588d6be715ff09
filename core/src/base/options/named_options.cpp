// Each kind takes its facts from the parts under a name, and knows no others.
#include "base/options/named_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "base/local_parts.h"
#include "paver/error.h"
#include "paver/units.h"

namespace paver {
namespace {

constexpr double largest = 1e30;  // of what is said of media and wires

/// Puts a number where it belongs; false for another name or no number.
bool put(const NamedParts& named, const std::map<std::string, double*>& places,
         std::optional<double> (*parse)(const std::string&)) {
  for (const auto& [fact, text] : named.facts) {
    const auto place = places.find(fact);
    if (place == places.end()) continue;
    const std::optional<double> value = parse(text);
    if (!value) return false;
    *place->second = *value;
  }
  return true;
}

/// Each of these facts once at most, and no others.
bool has_only(const NamedParts& named, std::set<std::string> facts) {
  for (const auto& [fact, text] : named.facts)
    if (facts.erase(fact) == 0) return false;
  return true;
}

[[noreturn]] void refuse(const std::string& text) { throw Error(ErrorCode::bad_option, text); }

/// A name that a mesh file can hold, and parts of these kinds.
void check_parts(const char* option, const std::string& name, const std::vector<std::string>& parts,
                 const std::set<PartKind>& kinds, const char* example) {
  if (name.empty()) refuse(fmt::format("{} has no name; write it like {}.", option, example));
  if (parts.empty()) refuse(fmt::format("{} '{}' names no part; write it like {}.", option, name, example));
  for (const std::string& part : parts) {
    const std::optional<PartName> parsed = parse_part(part);
    if (!parsed || !kinds.contains(parsed->kind))
      refuse(fmt::format("{} '{}' names '{}', which cannot be one; write it like {}.", option, name, part, example));
  }
}

void check_value(const char* option, const std::string& name, const char* what, double value, bool may_be_zero) {
  if (!((may_be_zero ? value >= 0 : value > 0) && value < largest))
    refuse(fmt::format("{} of {} '{}' is {:.6g}; it must be a finite number {} 0.", what, option, name, value,
                       may_be_zero ? "from" : "above"));
}

/// Refuses a part that is named a second time. `owner`: by part, what has it.
void take(const char* option, const std::string& name, const std::vector<std::string>& parts,
          std::map<std::string, std::string>& owner) {
  for (const std::string& part : parts) {
    const auto [known, is_new] = owner.emplace(part, name);
    if (!is_new)
      refuse(fmt::format("{} '{}' names {}, which '{}' has already; name it once.", option, name, part, known->second));
  }
}

/// Refuses names that would make one group of two things. `of`: by name, what else has it.
void take_name(const std::string& option, const std::string& name, const std::string& as,
               std::map<std::string, std::string>& of) {
  if (parse_part(name))
    refuse(
        fmt::format("{} '{}' is called like a part of the model, whose own group has that name; choose another name.",
                    option, name));
  const auto [known, is_new] = of.emplace(name, as);
  if (!is_new && known->second != as)
    refuse(fmt::format("{0} '{1}' has the name of {2}; choose another name, or give both the same values.", option,
                       name, known->second));
}

/// Losses shorten the wavelength: the real part of sqrt(eps_r (1 - j tan d)).
double loss(const Medium& medium) { return (1 + std::hypot(1.0, medium.loss_tangent)) / 2; }

}  // namespace

std::optional<Medium> parse_medium(const std::string& text) {
  const std::optional<NamedParts> named = parse_named(text, {"conductor"});
  if (!named || !has_only(*named, {"eps-r", "mu-r", "tan-d", "conductor"})) return std::nullopt;
  Medium medium{named->name, named->parts};
  if (!put(*named, {{"eps-r", &medium.eps_r}, {"mu-r", &medium.mu_r}, {"tan-d", &medium.loss_tangent}}, parse_number))
    return std::nullopt;
  for (const auto& [fact, value] : named->facts) medium.is_conductor = medium.is_conductor || fact == "conductor";
  return medium;
}

std::optional<Port> parse_port(const std::string& text) {
  const std::optional<NamedParts> named = parse_named(text, {});
  if (!named || !named->facts.empty()) return std::nullopt;
  return Port{named->name, named->parts};
}

std::optional<Wire> parse_wire(const std::string& text) {
  const std::optional<NamedParts> named = parse_named(text, {});
  if (!named || !has_only(*named, {"radius"})) return std::nullopt;
  Wire wire{named->name, named->parts};
  if (!put(*named, {{"radius", &wire.radius}}, parse_length)) return std::nullopt;
  return wire;
}

void check_named(const Options& options) {
  std::map<std::string, std::string> medium_of, group_of, media, groups;
  for (const Medium& medium : options.media) {
    check_parts("medium", medium.name, medium.parts, {PartKind::solid}, medium_example);
    check_value("medium", medium.name, "eps_r", medium.eps_r, false);
    check_value("medium", medium.name, "mu_r", medium.mu_r, false);
    check_value("medium", medium.name, "tan_d", medium.loss_tangent, true);
    take("medium", medium.name, medium.parts, medium_of);
    take_name("medium", medium.name,
              medium.is_conductor ? std::string("a conductor")
                                  : fmt::format("a medium with eps_r {:.6g}, mu_r {:.6g}, tan_d {:.6g}", medium.eps_r,
                                                medium.mu_r, medium.loss_tangent),
              media);
  }
  for (const Port& port : options.ports) {
    check_parts("port", port.name, port.parts, {PartKind::face, PartKind::edge, PartKind::vertex}, port_example);
    take("port", port.name, port.parts, group_of);
    take_name("port", port.name, "a port", groups);
  }
  for (const Wire& wire : options.wires) {
    check_parts("wire", wire.name, wire.parts, {PartKind::edge}, wire_example);
    check_value("wire", wire.name, "radius", wire.radius, false);
    take("wire", wire.name, wire.parts, group_of);
    take_name("wire", wire.name, fmt::format("a wire of radius {:.6g} mm", wire.radius), groups);
  }
}

std::optional<double> wavelength(const Options& options) {
  if (!options.frequency) return std::nullopt;
  return options.divisions * local_length(options, {"", std::nullopt, options.eps_r, options.mu_r});
}

std::optional<double> shortest_wavelength(const Options& options, const std::vector<std::string>& media) {
  if (!options.frequency) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const std::string& name : media) {
    if (name.empty()) least = std::min(least, *wavelength(options));
    for (const Medium& medium : options.media)
      if (medium.name == name && !medium.is_conductor)
        least = std::min(least, options.divisions * local_length(options, {"", std::nullopt,
                                                                           medium.eps_r * loss(medium), medium.mu_r}));
  }
  return std::isfinite(least) ? std::optional(least) : std::nullopt;
}

std::vector<LocalSize> lengths_in_media(const Options& options) {
  std::vector<LocalSize> lengths;
  if (!options.frequency) return lengths;
  for (const Medium& medium : options.media) {
    if (medium.is_conductor) continue;
    for (const std::string& part : medium.parts) {
      const LocalSize local{part, std::nullopt, medium.eps_r * loss(medium), medium.mu_r};
      if (local_length(options, local) < target_length(options)) lengths.push_back(local);
    }
  }
  return lengths;
}

}  // namespace paver
