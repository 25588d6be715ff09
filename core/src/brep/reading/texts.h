// Whether a file is as its writer left it, as far as its text tells.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace paver {

/// What is wrong in a text that OpenCASCADE has written, with its line: a table that ends early, a number that is none,
/// an entry that is not there. Empty when every entry can be found. OpenCASCADE's own reader looks for entries wherever
/// a number sends it, also outside of its memory.
std::string fault_of_brep(std::string_view text);

/// What is odd in the text: lines out of their order, entries that are no numbers, records of another length than they
/// say, pointers to nothing or to what cannot be meant. Empty when all is well. Odd files may be usable all the same.
std::string fault_of_iges(std::string_view text);

/// What the text of a STEP file says of its entities' names.
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
