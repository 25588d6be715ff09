// Lists in sentences.
#pragma once

#include <string>
#include <vector>

namespace paver {

/// "Face3, Face8 and 29 more": the first `most` of the items.
inline std::string listed(const std::vector<std::string>& items, std::size_t most, const std::string& more = "more",
                          const std::string& between = ", ") {
  std::string text;
  for (std::size_t i = 0; i < items.size() && i < most; ++i) text += (i ? between : "") + items[i];
  return items.size() > most ? text + " and " + std::to_string(items.size() - most) + " " + more : text;
}

}  // namespace paver
