// What becomes of a process whose CAD kernel breaks down, or comes to no end, on a damaged file; for the process that
// watches it.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

#include "paver/error.h"
#include "paver/progress.h"

namespace paver {

/// What to say of a process that a signal ended in a stage of meshing the model `name`: `who` it is called, and what to
/// choose where memory ran out.
Error breakdown(const std::string& name, Stage stage, int signal, const std::string& who = "Paver",
                const std::string& choice = "a larger target length or fewer threads");

/// Makes this process one that another watches and that may break down: doubtful files are read at once.
void allow_breakdown();
bool may_break_down();

/// First argument of the program paver when it tries a file for another process; then the file's path and name and that
/// process's number. It ends by a fault of the CAD kernel, or with 0 or this code.
inline constexpr const char* trial_command = "try";
inline constexpr int out_of_memory_exit_code = 9;

/// How the trial says that the file is refused, as the last it prints, and what another process reads from it.
std::string refusal_text(const Error& error);
std::optional<Error> refusal_in(const std::string& output);

/// Whether a process has used more time of processors in the stages that read a file and build its topology than any
/// sound file of that size needs: then it is to be ended by SIGXCPU.
bool is_hung(pid_t process, Stage stage, const std::string& path);

}  // namespace paver
