// Starting and watching one program with posix_spawn.
#include "base/process/child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "paver/error.h"

namespace paver {
namespace {

constexpr std::size_t kept_output = 1 << 14;

[[noreturn]] void fail(const std::string& program, int error_number) {
  throw Error(ErrorCode::internal,
              fmt::format("'{}' cannot be started ({}); check that it is a program for this machine.", program,
                          std::strerror(error_number)));
}

/// Both ends close in every program that is started; -1 when there is none.
using Ends = std::array<int, 2>;

Ends make_pipe() {
  Ends ends{};
  return ::pipe2(ends.data(), O_CLOEXEC) == 0 ? ends : Ends{-1, -1};
}

/// Unlike a pipe, it can be written to without a signal when the child has gone.
Ends make_socket() {
  Ends ends{};
  return ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0 ? ends : Ends{-1, -1};
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const std::vector<std::string>& environment) {
  Ends in = make_socket(), out = make_pipe();
  input_ = in[1];
  output_ = out[0];
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in[0], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t all, none;
  sigfillset(&all);
  sigemptyset(&none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setsigmask(&attributes, &none);
  int error = ::posix_spawn(&pid_, command[0].c_str(), &actions, &attributes, pointers(command).data(),
                            pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  for (int end : {in[0], out[1]})
    if (end >= 0) ::close(end);
  if (error == 0) {
    ::fcntl(output_, F_SETFL, O_NONBLOCK);
    return;
  }
  stop();
  if (output_ >= 0) ::close(output_);
  fail(command[0], error);
}

Child::~Child() {
  stop();
  if (!status()) {
    kill();
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(output_);
}

void Child::poke() {
  const char byte = 0;
  if (input_ >= 0) (void)!::send(input_, &byte, 1, MSG_NOSIGNAL);  // it may have ended
}

void Child::stop() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

void Child::kill(int signal) {
  if (!status()) ::kill(-pid_, signal);
}

bool Child::read_output() {
  std::array<char, 4096> part{};
  ssize_t bytes = 0;
  while ((bytes = ::read(output_, part.data(), part.size())) > 0) {
    last_output_.append(part.data(), static_cast<std::size_t>(bytes));
    if (last_output_.size() > kept_output) last_output_.erase(0, last_output_.size() - kept_output);
  }
  return bytes < 0 && (errno == EAGAIN || errno == EINTR);
}

std::optional<int> Child::status() {
  if (status_) return status_;
  int status = 0;
  pid_t ended = ::waitpid(pid_, &status, WNOHANG);
  if (ended == pid_) status_ = status;
  if (ended < 0 && errno == ECHILD) status_ = 0;  // a host that ignores its children has let the system reap it
  return status_;
}

}  // namespace paver
