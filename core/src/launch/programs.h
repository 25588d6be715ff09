// The programs that a run in several processes needs, and the environment they start in.
#pragma once

#include <string>
#include <vector>

#include "launch/run_folder.h"

namespace paver {

/// PAVER_MPIRUN, else mpirun on the PATH. Throws Error{bad_option} when there is none.
std::string find_mpirun(int ranks);

/// PAVER_WORKER, else paver-worker beside this program or library, else on the PATH. Throws Error{bad_option}.
std::string find_worker(int ranks);

/// paver-watch beside that worker, this program or this library, else on the PATH. Throws Error{bad_option}.
std::string find_watcher(const std::string& worker, int ranks);

/// This process's variables as "NAME=value", without those of an MPI run that it is part of, and with what keeps Open
/// MPI on this machine and in the run's folders.
std::vector<std::string> rank_environment(const RunFolder& folder, int ranks);

}  // namespace paver
