// OpenCASCADE follows what a file says into memory that is not there, and may loop for ever. The command line has one
// thread when it starts, so a fork costs a millisecond and needs no other program; what is done in the child is what
// would be done here.
#include "guard.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <new>

#include "paver/breakdown.h"
#include "paver/signals.h"

namespace paver {
namespace {

constexpr int look_milliseconds = 500;

/// In memory that a child shares; null where there is none.
Progress* make_shared_progress() {
  void* memory = ::mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? nullptr : new (memory) Progress;
}

void remove_temporaries(const Arguments& arguments, pid_t child) {
  for (const std::string& path : arguments.files.paths()) ::unlink(temporary_name(path, child).c_str());
}

/// How it ended, as waitpid() says. `end` is a pipe that closes when the child ends.
int wait_for(pid_t child, int end, const Arguments& arguments, const Progress& progress) {
  for (;;) {
    pollfd waited{end, POLLIN, 0};
    const int news = ::poll(&waited, 1, look_milliseconds);
    if (news > 0) break;
    if (news == 0 && is_hung(child, progress.stage(), arguments.input)) ::kill(child, SIGXCPU);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

[[noreturn]] void end_as(pid_t child, int status, const Arguments& arguments, const Progress& progress) {
  if (WIFEXITED(status)) ::_exit(WEXITSTATUS(status));
  remove_temporaries(arguments, child);
  const Error error = breakdown(arguments.input, progress.stage(), WTERMSIG(status));
  complain(error.what());
  ::_exit(exit_code(error.code()));
}

}  // namespace

void complain(std::string text) {
  auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  std::replace_if(text.begin(), text.end(), ends_line, ' ');
  fmt::print(stderr, "paver: {}\n", text);
}

void open_standard_streams() {
  for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", O_RDWR);
}

Progress& guard_run(const Arguments& arguments) {
  static Progress own;
  Progress* progress = make_shared_progress();
  cancel_on_signals(progress ? *progress : own);
  std::array<int, 2> ends{};
  if (!progress || ::pipe2(ends.data(), O_CLOEXEC) != 0) return progress ? *progress : own;
  const pid_t us = ::getpid(), child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != us) progress->cancel();
    allow_breakdown();
    return *progress;
  }
  ::close(ends[1]);
  if (child > 0) end_as(child, wait_for(child, ends[0], arguments, *progress), arguments, *progress);
  ::close(ends[0]);
  return *progress;
}

}  // namespace paver
