// Ranks in one process, a thread each: what runs on several processes can be tested in one program.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "paver/ranks.h"

namespace paver::test {

/// Thrown out of a collective call because another rank has thrown.
struct Released : std::runtime_error {
  Released() : std::runtime_error("another rank has failed") {}
};

/// Calls `task` on `count` ranks at once, a thread each, and returns when all have ended. An exception in one rank
/// releases the others; the first that is not Released, by rank, is thrown on. Ranks that do not call the same
/// collective functions get std::logic_error instead of waiting for ever.
void run_on_ranks(int count, const std::function<void(Ranks&)>& task);

/// The meeting point of all ranks; used by run_on_ranks.
class Meeting {
 public:
  explicit Meeting(int count) : count_(count), given_(static_cast<std::size_t>(count)) {}

  /// Waits for all ranks, each of which gives something under the same `name`; what all gave, by rank.
  std::vector<std::string> exchange(int rank, const std::string& name, std::string_view mine);
  long take(int queue) { return queues_.take(queue); }
  int count() const { return count_; }
  /// A rank has ended: no one must wait for it any more.
  void leave(bool has_failed);

 private:
  void wait_for_all(std::unique_lock<std::mutex>& lock);

  const int count_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0, left_ = 0;
  long round_ = 0;
  bool is_broken_ = false, is_mismatched_ = false;
  std::string name_;
  std::vector<std::string> given_;
  SingleRank queues_;
};

}  // namespace paver::test
