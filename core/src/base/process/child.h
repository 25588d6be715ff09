// A program that runs beside this process until it ends or is stopped.
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace paver {

/// As programs are started with, a null pointer at the end.
inline std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (const std::string& text : texts) list.push_back(const_cast<char*>(text.c_str()));
  list.push_back(nullptr);
  return list;
}

/// The child has a process group of its own, all signals at their defaults, our end of a socket as stdin, and a pipe
/// as stdout and stderr.
class Child {
 public:
  /// Throws Error{internal} when it cannot be started.
  Child(const std::vector<std::string>& command, const std::vector<std::string>& environment);
  /// Kills its process group when it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Writes one byte to its stdin.
  void poke();
  /// Closes its stdin, by which it knows that it must end.
  void stop();
  /// A signal to it and to all that it has started.
  void kill(int signal = SIGKILL);
  pid_t process() const { return pid_; }
  /// Where its output comes, to wait for with poll().
  int output() const { return output_; }
  /// Takes what has come and keeps the last part; false when the child has closed its output.
  bool read_output();
  const std::string& last_output() const { return last_output_; }
  /// How it ended, as waitpid() says; nothing as long as it runs.
  std::optional<int> status();

 private:
  pid_t pid_ = -1;
  int input_ = -1, output_ = -1;
  std::optional<int> status_;
  std::string last_output_;
};

}  // namespace paver
