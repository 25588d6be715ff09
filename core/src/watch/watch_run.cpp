// Ends a run with all its processes, whichever of them was killed. Processes that lost their parent become this one's
// (it is a "subreaper"), so that none can get away.
#include "watch/watch_run.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "base/process/child.h"
#include "base/process/run_files.h"

namespace paver {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int not_started_exit_code = 127;
constexpr milliseconds patience(1200);  // for ranks to end by themselves, once the run is stopped

enum class Wish { run, kill, stop };  ///< of the asking process

volatile sig_atomic_t is_signalled = 0;

void handle_stop(int) { is_signalled = 1; }
void handle_child(int) {}  // only has to wake wait_for_news()

/// Signals come only while wait_for_news() waits, so that none is missed just before.
void listen_to_signals() {
  sigset_t heard;
  sigemptyset(&heard);
  for (int number : {SIGINT, SIGTERM, SIGHUP, SIGCHLD}) {
    struct sigaction action = {};
    action.sa_handler = number == SIGCHLD ? handle_child : handle_stop;
    ::sigaction(number, &action, nullptr);
    sigaddset(&heard, number);
  }
  ::sigprocmask(SIG_BLOCK, &heard, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
}

/// Until a signal comes or `input` (none: -1) can be read, at most for `longest` (negative: without limit). Whether the
/// input can be read.
bool wait_for_news(int input, milliseconds longest) {
  sigset_t none;
  sigemptyset(&none);
  timespec limit{longest.count() / 1000, longest.count() % 1000 * 1000000};
  pollfd waited{input, POLLIN, 0};
  return ::ppoll(&waited, 1, longest.count() < 0 ? nullptr : &limit, &none) > 0;
}

/// What the asking process says next, or that we are told to stop by a signal; waits for either or for a child's end.
Wish next_wish() {
  bool has_input = wait_for_news(STDIN_FILENO, milliseconds(-1));
  if (is_signalled) return Wish::stop;
  char ignored = 0;
  if (!has_input) return Wish::run;
  return ::read(STDIN_FILENO, &ignored, 1) > 0 ? Wish::kill : Wish::stop;
}

pid_t start(const std::vector<std::string>& command) {
  const std::vector<char*> arguments = pointers(command);
  pid_t us = ::getpid(), pid = ::fork();
  if (pid != 0) return pid;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != us) ::_exit(not_started_exit_code);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::execv(arguments[0], arguments.data());
  ::_exit(not_started_exit_code);
}

/// Parent of a process, 0 when there is none.
pid_t parent(const fs::path& process) {
  std::ifstream stat(process / "stat");
  std::string text;
  std::getline(stat, text);
  auto after_name = text.rfind(')');
  return after_name != std::string::npos && after_name + 4 < text.size() ? std::atoi(text.c_str() + after_name + 4) : 0;
}

/// Processes whose parent is this one.
std::vector<pid_t> children() {
  std::vector<pid_t> result;
  std::ifstream list("/proc/thread-self/children");
  if (list) {
    for (pid_t pid = 0; list >> pid;) result.push_back(pid);
    return result;
  }
  std::error_code error;  // a kernel that keeps no list
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    pid_t pid = std::atoi(entry->path().filename().c_str());
    if (pid > 0 && parent(entry->path()) == ::getpid()) result.push_back(pid);
  }
  return result;
}

/// Kills all processes that descend from this one and waits for them: what a killed child has left is ours next.
void kill_descendants() {
  do {
    for (pid_t pid : children()) ::kill(pid, SIGKILL);
  } while (::waitpid(-1, nullptr, 0) > 0 || errno != ECHILD);
}

/// Waits for the command, as long as the asking process wishes. How it ended, as waitpid() says.
int wait_for(pid_t pid, Wish& wish) {
  Clock::time_point stopped_at;
  if (pid < 0) return W_EXITCODE(not_started_exit_code, 0);
  while (true) {
    int status = 0;
    for (pid_t ended = 0; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;)
      if (ended == pid) return status;  // others had lost their parent
    if (wish == Wish::stop) {
      auto left = std::chrono::ceil<milliseconds>(stopped_at + patience - Clock::now());
      if (left.count() <= 0) return SIGKILL;
      wait_for_news(-1, left);
      continue;
    }
    wish = next_wish();
    if (wish == Wish::kill) return 0;
    if (wish == Wish::stop) {
      stopped_at = Clock::now();
      ::kill(pid, SIGTERM);
    }
  }
}

void remove_outputs(const std::string& folder) {
  std::ifstream list(fs::path(folder) / temporaries_file);
  for (std::string name; std::getline(list, name);)
    if (!name.empty()) ::unlink(name.c_str());
}

}  // namespace

int watch_run(const std::vector<std::string>& folders, const std::vector<std::string>& command) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  listen_to_signals();
  Wish wish = Wish::run;
  int status = wait_for(start(command), wish);
  kill_descendants();
  remove_outputs(folders.front());
  ::close(STDOUT_FILENO);
  ::close(STDERR_FILENO);
  while (wish != Wish::stop) wish = next_wish();
  std::error_code ignored;
  for (const std::string& folder : folders) fs::remove_all(folder, ignored);
  return WIFEXITED(status) ? WEXITSTATUS(status) : signal_exit_code + WTERMSIG(status);
}

}  // namespace paver
