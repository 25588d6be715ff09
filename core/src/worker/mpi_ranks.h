// Ranks as MPI processes. Make one after MPI_Init_thread with at least MPI_THREAD_SERIALIZED.
#pragma once

#include <mpi.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <thread>

#include "paver/progress.h"
#include "paver/ranks.h"

namespace paver {

/// Every call of MPI is made under one mutex and comes back at once: what has to wait asks again and again and sleeps
/// in between. So a thread that takes from a queue never waits for one in a collective, idle ranks leave their cores to
/// busy ones, and a cancelled rank stops waiting with Error{cancelled}.
class MpiRanks : public Ranks {
 public:
  /// Collective. Messages longer than `most_bytes` in all go in pieces of at most that size (MPI counts in int).
  explicit MpiRanks(const Progress& progress, std::size_t most_bytes = std::size_t(1) << 30);
  /// Not collective. Ends nothing of MPI: call finish() first where all went well.
  ~MpiRanks() override;
  MpiRanks(const MpiRanks&) = delete;
  MpiRanks& operator=(const MpiRanks&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }
  std::vector<std::string> gather(std::string_view mine) override;
  std::vector<std::string> exchange(const std::vector<std::string>& mine) override;
  void add_up(std::span<long> values) override;
  void find_least(std::span<double> values) override;
  long take(int queue) override;

  /// Collective: what rank 0 has, everywhere.
  void spread(std::string& text);
  /// Number of ranks on this machine.
  int count_here() const { return count_here_; }
  /// Whether this is the first call of all ranks: who reports an error that happens on several.
  bool is_first() { return take(first_queue) == 0; }
  /// Seconds that this rank has waited for others in collective functions.
  double waited_seconds() const { return waited_; }
  /// Collective: lets go of what MPI holds; the last call before MPI_Finalize.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int first_queue = most_queues, windows = most_queues + 1;

  template <class Start>
  void complete(Start start);
  void wait(MPI_Request& request);
  template <class T>
  void reduce(std::span<T> values, MPI_Datatype type, MPI_Op operation);
  void spread(char* data, std::uint64_t bytes, int root);
  void keep_going();
  void stop_thread();

  const Progress& progress_;
  std::size_t most_bytes_;
  int rank_ = 0, count_ = 1, count_here_ = 1;
  double waited_ = 0;
  std::mutex mutex_;           ///< held in every call of MPI
  bool is_abandoned_ = false;  ///< cancelled within a collective: no call of MPI any more
  MPI_Win window_ = MPI_WIN_NULL;
  std::int64_t* counters_ = nullptr;  ///< at rank 0
  std::atomic<bool> is_stopping_{false};
  std::thread thread_;  ///< at rank 0
};

}  // namespace paver
