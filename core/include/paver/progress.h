// Shared progress counter and cancel flag, readable and settable from any thread.
#pragma once

#include <atomic>

#include "paver/error.h"

namespace paver {

/// The stages of one run, in order.
enum class Stage { read, topology, sizing, boundary, regions, paving, repair, join, curving, quality, write, done };

/// Name as printed, e.g. "paving".
const char* stage_name(Stage stage);

class Progress {
 public:
  /// Asks the run to stop; it throws Error{cancelled} at its next check. Safe in a signal handler.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool is_cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

  /// Throws Error{cancelled} when cancel() was called. Called often by every stage: cheap.
  void check() const {
    if (is_cancelled()) throw Error(ErrorCode::cancelled, "Cancelled; nothing was written.");
  }
  /// Starts a stage of `total` work units (>= 1).
  void begin(Stage stage, long total = 1) {
    check();
    done_.store(0);
    total_.store(total > 0 ? total : 1);
    stage_.store(static_cast<int>(stage));
  }
  /// Credits work units, then check().
  void advance(long units = 1) {
    done_.fetch_add(units, std::memory_order_relaxed);
    check();
  }
  Stage stage() const { return static_cast<Stage>(stage_.load()); }
  /// Share of the current stage that is done, 0 to 1.
  double fraction() const {
    double f = static_cast<double>(done_.load()) / static_cast<double>(total_.load());
    return f < 1 ? f : 1;
  }

 private:
  std::atomic<bool> cancelled_{false};
  std::atomic<int> stage_{0};
  std::atomic<long> done_{0}, total_{1};
};

}  // namespace paver
