// What becomes of a process whose CAD kernel breaks down, or comes to no end, on a damaged file; for the process that
// watches it.
#pragma once

#include <sys/types.h>

#include <string>

#include "paver/error.h"
#include "paver/progress.h"

namespace paver {

/// What to say of a process that a signal ended in a stage of meshing the model `name`.
Error breakdown(const std::string& name, Stage stage, int signal);

/// Whether a process has used more time of processors in the stages that read a file and build its topology than any
/// sound file of that size needs: then it is to be ended by SIGXCPU.
bool is_hung(pid_t process, Stage stage, const std::string& path);

}  // namespace paver
