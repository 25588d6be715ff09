// What the user sees and how the user stops: progress lines, signals, and an end within a second.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "paver/progress.h"

namespace paver {

/// While it lives, a thread of its own prints how far `progress` is: on a terminal one line on stderr that is written
/// over, else one line on stdout per finished stage, so that stderr holds nothing but errors. When a cancelled run
/// does not come back within `patience`, the thread removes `temporaries` and ends the process with code 130.
class Terminal {
 public:
  Terminal(const Progress& progress, bool is_quiet, std::vector<std::string> temporaries,
           std::chrono::milliseconds patience = std::chrono::milliseconds(700));
  /// Ends the thread and clears its line.
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  void watch(std::stop_token stop);
  void show();
  void show_on_line();
  void show_finished_stages();
  void end_process() const;

  const Progress& progress_;
  bool is_quiet_, is_terminal_;
  std::vector<std::string> temporaries_;
  std::chrono::milliseconds patience_;
  std::string shown_;
  int stage_ = 0;
  Clock::time_point stage_start_;
  std::mutex mutex_;
  std::condition_variable_any stopping_;
  std::jthread thread_;
};

}  // namespace paver
