// Where the other parts of an installation lie.
#pragma once

#include <filesystem>
#include <vector>

namespace paver {

/// Folder of this library, folder of this program, and where the build folder has the core from either, or an
/// installation: lib/paver and bin, from bin/paver or lib/python3/dist-packages/paver/.
std::vector<std::filesystem::path> own_folders();

}  // namespace paver
