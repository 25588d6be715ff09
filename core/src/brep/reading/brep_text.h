// Whether a BREP text says what its own counts promise.
#pragma once

#include <string>
#include <string_view>

namespace paver {

/// What is wrong in a text that OpenCASCADE has written, with its line: a table that ends early, a number that is none,
/// an entry that is not there. Empty when every entry can be found. OpenCASCADE's own reader looks for entries wherever
/// a number sends it, also outside of its memory.
std::string fault_of_brep(std::string_view text);

}  // namespace paver
