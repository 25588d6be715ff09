// Files in the folder of a run in several processes that more than one program knows.
#pragma once

#include <span>
#include <string>

namespace paver {

/// Lists the temporary names of the run's outputs, one per line; the watcher removes what ranks that were killed have
/// left of them.
inline constexpr const char* temporaries_file = "temporaries";

/// Throws Error{unwritable_output}.
void write_run_file(const std::string& path, std::span<const char> content);

}  // namespace paver
