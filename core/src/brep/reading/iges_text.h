// Whether an IGES file is as its writer left it, as far as its text tells.
#pragma once

#include <string>
#include <string_view>

namespace paver {

/// What is odd in the text: lines out of their order, entries that are no numbers, records of another length than they
/// say, pointers to nothing or to what cannot be meant. Empty when all is well. Odd files may be usable all the same.
std::string fault_of_iges(std::string_view text);

}  // namespace paver
