// Splitting at separators; numbers and units are those of paver/units.h.
#include "base/local_parts.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "base/trimmed.h"
#include "paver/units.h"

namespace paver {
namespace {

constexpr std::pair<std::string_view, PartKind> kinds[] = {
    {"Face", PartKind::face}, {"Edge", PartKind::edge}, {"Vertex", PartKind::vertex}, {"Solid", PartKind::solid}};

std::vector<std::string> pieces(const std::string& text, char separator) {
  std::vector<std::string> list;
  for (std::size_t from = 0; from <= text.size();) {
    std::size_t to = std::min(text.find(separator, from), text.size());
    list.emplace_back(trimmed(std::string_view(text).substr(from, to - from)));
    from = to + 1;
  }
  return list;
}

// "eps-r:4,mu-r:1.5"
bool read_medium(const std::string& text, LocalSize& local) {
  for (const std::string& item : pieces(text, ',')) {
    std::size_t colon = item.find(':');
    if (colon == std::string::npos) return false;
    std::string name(trimmed(std::string_view(item).substr(0, colon)));
    std::optional<double> value = parse_number(item.substr(colon + 1));
    if (!value) return false;
    std::replace(name.begin(), name.end(), '_', '-');
    if (name != "eps-r" && name != "mu-r") return false;
    (name == "eps-r" ? local.eps_r : local.mu_r) = *value;
  }
  return true;
}

}  // namespace

std::optional<PartName> parse_part(const std::string& name) {
  for (auto [word, kind] : kinds) {
    if (!name.starts_with(word)) continue;
    int number = 0;
    const char *begin = name.data() + word.size(), *end = name.data() + name.size();
    auto [rest, error] = std::from_chars(begin, end, number);
    if (error == std::errc() && rest == end && number >= 1) return PartName{kind, number - 1};
  }
  return std::nullopt;
}

std::optional<std::vector<LocalSize>> parse_local(const std::string& text) {
  std::vector<LocalSize> list;
  for (const std::string& item : pieces(text, ';')) {
    std::size_t equals = item.find('=');
    if (equals == std::string::npos) return std::nullopt;
    LocalSize local;
    const std::string value(trimmed(std::string_view(item).substr(equals + 1)));
    local.size = parse_length(value);
    if (!local.size && !read_medium(value, local)) return std::nullopt;
    for (const std::string& name : pieces(item.substr(0, equals), ',')) {
      local.part = name;
      list.push_back(local);
    }
  }
  return list;
}

std::optional<NamedParts> parse_named(const std::string& text, const std::vector<std::string>& flags) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos) return std::nullopt;
  NamedParts named;
  named.name = trimmed(std::string_view(text).substr(0, equals));
  for (const std::string& item : pieces(text.substr(equals + 1), ',')) {
    const std::size_t colon = item.find(':');
    if (colon != std::string::npos) {
      std::string fact(trimmed(std::string_view(item).substr(0, colon)));
      std::replace(fact.begin(), fact.end(), '_', '-');
      named.facts.emplace_back(fact, trimmed(std::string_view(item).substr(colon + 1)));
    } else if (std::find(flags.begin(), flags.end(), item) != flags.end()) {
      named.facts.emplace_back(item, "");
    } else {
      named.parts.push_back(item);
    }
  }
  return named;
}

}  // namespace paver
