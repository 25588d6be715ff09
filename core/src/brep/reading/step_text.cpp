// Entities are "#12=NAME(...,#7,...);"; texts in quotes and comments may hold anything.
#include <algorithm>
#include <charconv>
#include <iterator>

#include "brep/reading/texts.h"

namespace paver {
namespace {

/// What follows text or comment at `at`; `at` itself where neither starts.
std::size_t behind_text(std::string_view text, std::size_t at) {
  const bool is_comment = text.substr(at).starts_with("/*");
  if (text[at] != '\'' && !is_comment) return at;
  const std::size_t end = is_comment ? text.find("*/", at + 2) : text.find('\'', at + 1);
  return end == std::string_view::npos ? text.size() : end + (is_comment ? 2 : 1);
}

}  // namespace

StepNames find_step_names(std::string_view text) {
  StepNames names;
  std::vector<std::uint64_t> defined, used;
  for (std::size_t at = 0; (at = text.find_first_of("#'/&", at)) < text.size();) {
    if (const std::size_t behind = behind_text(text, at); behind != at) {
      at = behind;
      continue;
    }
    names.has_scopes |= text.substr(at).starts_with("&SCOPE");
    if (text[at++] != '#') continue;
    std::uint64_t number = 0;
    auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    names.is_whole &= error == std::errc();
    if (error != std::errc()) continue;
    at = static_cast<std::size_t>(end - text.data());
    const std::size_t next = text.find_first_not_of(" \t\r\n", at);
    (next != std::string_view::npos && text[next] == '=' ? defined : used).push_back(number);
  }
  std::sort(defined.begin(), defined.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (const auto twice = std::adjacent_find(defined.begin(), defined.end()); twice != defined.end())
    names.doubled = *twice;
  std::set_difference(used.begin(), used.end(), defined.begin(), defined.end(), std::back_inserter(names.missing));
  names.is_whole &= names.missing.empty();
  return names;
}

}  // namespace paver
