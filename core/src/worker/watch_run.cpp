// Ends a run with all its processes, whichever of them was killed. Processes that lost their parent become this one's
// (it is a "subreaper"), so that none can get away.
#include "worker/watch_run.h"

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
#include <map>
#include <thread>

namespace paver {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int poll_milliseconds = 20, not_started_exit_code = 127, signal_exit_code = 128;
constexpr std::chrono::milliseconds patience(1200);  // for ranks to end by themselves, once the run is stopped

volatile sig_atomic_t is_signalled = 0;

void handle_signal(int) { is_signalled = 1; }

pid_t start(const std::vector<std::string>& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  pid_t us = ::getpid(), pid = ::fork();
  if (pid != 0) return pid;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != us) ::_exit(not_started_exit_code);
  int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::execv(arguments[0], arguments.data());
  ::_exit(not_started_exit_code);
}

/// Whether the asking process has closed its end; waits a little for that.
bool is_asker_gone() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, poll_milliseconds) <= 0) return false;
  char ignored = 0;
  return ::read(STDIN_FILENO, &ignored, 1) <= 0;
}

/// Parent of each process of the system.
std::map<pid_t, pid_t> parents() {
  std::map<pid_t, pid_t> result;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
    pid_t pid = std::atoi(entry->path().filename().c_str());
    if (pid <= 0) continue;
    std::ifstream stat(entry->path() / "stat");
    std::string text;
    std::getline(stat, text);
    auto after_name = text.rfind(')');
    if (after_name != std::string::npos && after_name + 4 < text.size())
      result[pid] = std::atoi(text.c_str() + after_name + 4);
  }
  return result;
}

/// Kills all processes that descend from this one and waits for them. Those that start in between are found next time.
void kill_descendants() {
  while (true) {
    std::map<pid_t, pid_t> parent = parents();
    for (auto [pid, above] : parent) {
      for (; above > 1 && above != ::getpid(); above = parent.contains(above) ? parent[above] : 0) {
      }
      if (above == ::getpid()) ::kill(pid, SIGKILL);
    }
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    if (::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Waits for the command; stops it when nobody wants it any more. How it ended, as waitpid() says.
int wait_for(pid_t pid, bool& is_stopped) {
  Clock::time_point stopped_at;
  int status = 0;
  while (true) {
    pid_t ended = ::waitpid(-1, &status, WNOHANG);
    if (ended == pid) return status;
    if (ended > 0) continue;  // one that lost its parent
    if (is_stopped) {
      std::this_thread::sleep_for(std::chrono::milliseconds(poll_milliseconds));
      if (Clock::now() - stopped_at > patience) return SIGKILL;
    } else if (is_asker_gone() || is_signalled) {
      is_stopped = true;
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

int watch_run(const WatchedRun& run) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  struct sigaction action {};
  action.sa_handler = handle_signal;
  for (int number : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(number, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);
  bool is_stopped = false;
  int status = wait_for(start(run.command), is_stopped);
  kill_descendants();
  remove_outputs(run.folders.front());
  ::close(STDOUT_FILENO);
  ::close(STDERR_FILENO);
  while (!is_stopped) is_stopped = is_asker_gone() || is_signalled;
  std::error_code ignored;
  for (const std::string& folder : run.folders) fs::remove_all(folder, ignored);
  return WIFEXITED(status) ? WEXITSTATUS(status) : signal_exit_code + WTERMSIG(status);
}

}  // namespace paver
