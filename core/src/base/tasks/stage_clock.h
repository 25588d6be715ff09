// How long each stage took, and how often it began.
#pragma once

#include <chrono>

#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Writes to the report, tells `progress`. References are kept.
class StageClock {
 public:
  StageClock(RunReport& report, Progress& progress) : report_(report), progress_(progress) {}

  /// The stage before ends; nothing when it is the same.
  void begin(Stage stage);
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  RunReport& report_;
  Progress& progress_;
  Stage stage_ = Stage::done;
  Clock::time_point started_;
};

}  // namespace paver
