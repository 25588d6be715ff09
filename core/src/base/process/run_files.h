// What more than one program knows of a run in several processes.
#pragma once

#include <span>
#include <string>

namespace paver {

/// The watcher's exit code when the run was ended by a signal: this and the signal's number.
inline constexpr int signal_exit_code = 128;

/// In the run's folder. Lists the temporary names of the run's outputs, one per line; the watcher removes what ranks
/// that were killed have left of them.
inline constexpr const char* temporaries_file = "temporaries";

/// Throws Error{unwritable_output}.
void write_run_file(const std::string& path, std::span<const char> content);

}  // namespace paver
