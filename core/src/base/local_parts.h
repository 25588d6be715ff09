// Target lengths of parts of the model, as text.
#pragma once

#include <optional>
#include <string>
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

}  // namespace paver
