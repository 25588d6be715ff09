// Whether a STEP file is as its writer left it, as far as its text tells.
#pragma once

#include <string_view>

namespace paver {

/// Whether every entity that the text names is there, once. OpenCASCADE's reader goes on without those that are not.
bool is_step_whole(std::string_view text);

}  // namespace paver
