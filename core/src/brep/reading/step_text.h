// Whether a STEP file is as its writer left it, as far as its text tells.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace paver {

/// What the text says of its entities' names.
struct StepNames {
  std::uint64_t doubled = 0;           ///< least number of an entity that is there more than once, or 0
  bool is_whole = true;                ///< every entity that is named has a number, and is there
  bool has_scopes = false;             ///< in which names may be used again (first edition of ISO 10303-21)
  std::vector<std::uint64_t> missing;  ///< numbers of entities that are named, and are not there
};

/// OpenCASCADE's reader goes on without entities that are missing; where one is there twice it looks for others in
/// memory that it has not set, and may come to no end (StepData_StepReaderData::SetEntityNumbers).
StepNames find_step_names(std::string_view text);

}  // namespace paver
