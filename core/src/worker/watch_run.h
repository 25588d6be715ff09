// The process between the one that asked for a run and mpirun.
#pragma once

#include <string>
#include <vector>

namespace paver {

/// What it starts, and the folders that it removes.
struct WatchedRun {
  std::vector<std::string> folders;  ///< the first is that of the job
  std::vector<std::string> command;  ///< mpirun and its arguments
};

/// Runs the command. Stdin is a pipe from the asking process that never carries anything: when it closes, the run is
/// stopped. When the command has ended, all that it started and that is left is killed, stdout and stderr are closed,
/// and once stdin is closed, the folders are removed. Gives the command's exit code, 128 + n for signal n.
int watch_run(const WatchedRun& run);

/// File in the job's folder that lists the temporary names of the run's outputs, one per line; the watcher removes what
/// ranks that were killed have left of them.
inline const char* const temporaries_file = "temporaries";

}  // namespace paver
