// What a rank says while it works, and what it listens to.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "paver/launch.h"

namespace paver {

/// Makes SIGINT, SIGTERM and SIGHUP, and the end of the parent process, cancel `progress`, which must live as long as
/// the process. A file that grows beyond a limit and a reader that goes away become write errors instead of signals.
void listen_to_signals(Progress& progress);

/// While it lives, a thread of its own says at rank 0 how far `progress` is, cancels it when nobody reads what the rank
/// says any more, and ends the process when a cancelled run does not come back in time.
class Reporter {
 public:
  Reporter(Progress& progress, const Job& job, int rank);
  ~Reporter();
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  /// Files to remove when the process must end.
  void set_temporaries(std::vector<std::string> temporaries);
  void started(int ranks, int threads);
  void failed(const Error& error);
  /// At rank 0: the run is done, and its files are in place.
  void done(const MeshResult& result, const std::vector<double>& busy_seconds);
  void remove_temporaries() const;
  /// Removes the temporary files and ends the process at once.
  [[noreturn]] void end_process(int code);

 private:
  enum class Style { lines, table, silent };  ///< events; for people; the other ranks there

  void open(const std::string& events);
  void watch(std::stop_token stop);
  void show();
  void show_finished_stages();
  void say(const std::string& line, bool is_needed);
  bool is_heard() const;

  Progress& progress_;
  Job job_;
  int rank_, descriptor_ = -1;
  Style style_ = Style::silent;
  std::string shown_;
  int stage_ = 0;
  std::chrono::steady_clock::time_point stage_start_;
  std::mutex mutex_;
  std::vector<std::string> temporaries_;
  std::condition_variable_any stopping_;
  std::jthread thread_;
};

}  // namespace paver
