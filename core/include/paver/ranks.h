// Several processes that share one run. The core knows them only by this interface; the worker implements it with MPI.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace paver {

/// One process among count() equal ones. Collective functions are called by all of them in the same order, from one
/// thread each, and return when all have called.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  /// Collective: what each rank gives, by rank. Any bytes, of different lengths; empty ones, too.
  virtual std::vector<std::string> gather(std::string_view mine) = 0;
  /// Collective: mine[r] is for rank r; what each rank has for this one, by rank. Bytes as above.
  virtual std::vector<std::string> exchange(const std::vector<std::string>& mine) = 0;
  /// Collective: each value becomes its sum over all ranks; same number of values everywhere.
  virtual void add_up(std::span<long> values) = 0;
  /// Collective: likewise the least of all ranks. No value is NaN; which sign the least of several zeros has is open.
  virtual void find_least(std::span<double> values) = 0;
  /// The next number of a queue, 0, 1, 2, ...; each is given to one caller of all ranks only. Not collective, may be
  /// called from any thread. 0 <= queue < most_queues.
  virtual long take(int queue) = 0;

  static constexpr int most_queues = 256;  ///< of one run
};

/// A process on its own.
class SingleRank : public Ranks {
 public:
  int rank() const override { return 0; }
  int count() const override { return 1; }
  std::vector<std::string> gather(std::string_view mine) override { return {std::string(mine)}; }
  std::vector<std::string> exchange(const std::vector<std::string>& mine) override { return mine; }
  void add_up(std::span<long>) override {}
  void find_least(std::span<double>) override {}
  long take(int queue) override { return next_[static_cast<std::size_t>(queue)].fetch_add(1); }

 private:
  std::array<std::atomic<long>, most_queues> next_{};
};

}  // namespace paver
