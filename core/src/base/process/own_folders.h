// Where the other parts of an installation lie.
#pragma once

#include <optional>
#include <string>

namespace paver {

/// A file that we may use (`mode`: as access() takes it) in the folder of this library, in that of this program, or
/// where the build folder has the core from either, or an installation: lib/paver and bin, from bin/paver or
/// lib/python3/dist-packages/paver/.
std::optional<std::string> beside_us(const std::string& name, int mode);

}  // namespace paver
