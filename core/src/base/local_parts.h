// Parts of the model, as text: with target lengths, and under a name.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "paver/options.h"

namespace paver {

enum class PartKind { face, edge, vertex, solid };

struct PartName {
  PartKind kind = PartKind::face;
  int index = 0;  ///< 0-based
};

/// "Face3" and the like; nothing for other text.
std::optional<PartName> parse_part(const std::string& name);

/// "Face3=2mm", "Face3,Edge5=0.5mm", "Solid1=eps-r:4,mu-r:1.5"; several of these with semicolons between them. Names
/// and ranges are left to check(Options). Nothing for text of another form.
std::optional<std::vector<LocalSize>> parse_local(const std::string& text);

/// Parts under a name, and what is said of them: "eps-r" and "4.4" of "eps-r:4.4", "conductor" and "".
struct NamedParts {
  std::string name;
  std::vector<std::string> parts;
  std::vector<std::pair<std::string, std::string>> facts;
};

/// "FR4=Solid1,Solid2,eps-r:4.4", "Feed=Edge5". The name ends at the last "=". An item with a colon is a
/// fact, and so is one of `flags`. Nothing for text of another form.
std::optional<NamedParts> parse_named(const std::string& text, const std::vector<std::string>& flags);

}  // namespace paver
