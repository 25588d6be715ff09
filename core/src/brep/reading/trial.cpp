// The other process is the command line's program. A file costs it a start and is read twice: that is why only doubtful
// ones are tried (core/docs/decisions/damaged-files.md).
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/process/child.h"
#include "base/process/own_folders.h"
#include "brep/reading/readers_impl.h"
#include "paver/breakdown.h"

namespace paver {
namespace {

constexpr int look_milliseconds = 20;

std::string program(const FileSource& file) {
  if (auto path = beside_us("paver", F_OK)) return *path;
  throw Error(ErrorCode::internal, "'" + file.name +
                                       "' is damaged or odd and is only read where the program paver can try it first, "
                                       "which is missing; build Paver again or install all of it.");
}

/// A file that only this process has open, as others see it.
std::string path_for_others(const std::string& path) {
  constexpr std::string_view own = "/proc/self/";
  return path.starts_with(own) ? fmt::format("/proc/{}/{}", ::getpid(), path.substr(own.size())) : path;
}

std::vector<std::string> own_environment() {
  std::vector<std::string> list;
  for (char** variable = environ; *variable; ++variable) list.emplace_back(*variable);
  return list;
}

/// What waitpid() says of it.
int wait_for(Child& child, const std::string& path, Stage& stage, const Progress& progress) {
  for (bool is_open = true; is_open;) {
    progress.check();
    pollfd waited{child.output(), POLLIN, 0};
    ::poll(&waited, 1, look_milliseconds);
    is_open = child.read_output();
    if (child.last_output().ends_with(std::string(stage_name(Stage::topology)) + "\n")) stage = Stage::topology;
    if (is_open && is_hung(child.process(), stage, path)) child.kill(SIGXCPU);
  }
  while (!child.status()) {
    progress.check();
    ::poll(nullptr, 0, 1);
  }
  return *child.status();
}

}  // namespace

void try_elsewhere(const FileSource& file, const Progress& progress) {
  if (may_break_down()) return;
  Child child({program(file), trial_command, path_for_others(file.path), file.name, std::to_string(::getpid())},
              own_environment());
  Stage stage = Stage::read;
  const int status = wait_for(child, file.path, stage, progress);
  if (WIFSIGNALED(status)) throw Error(breakdown(file.name, stage, WTERMSIG(status)));
  if (WEXITSTATUS(status) == out_of_memory_exit_code)
    throw Error(ErrorCode::out_of_memory,
                "'" + file.name + "' takes more memory than there is; export the model again, it may be damaged.");
  if (auto refusal = refusal_in(child.last_output())) throw *refusal;
}

}  // namespace paver
