// The process between the one that asked for a run and mpirun.
#pragma once

#include <string>
#include <vector>

namespace paver {

/// Runs the command, mpirun and its arguments. Stdin is a pipe from the asking process: a byte on it says that the
/// outputs are in place, so that the rest of the run can be killed; when it closes before, the run is stopped. When the
/// command has ended, all that it started and that is left is killed, stdout and stderr are closed, and once stdin is
/// closed, the folders are removed, of which the first is that of the job. Gives the command's exit code, 128 + n for
/// signal n.
int watch_run(const std::vector<std::string>& folders, const std::vector<std::string>& command);

}  // namespace paver
