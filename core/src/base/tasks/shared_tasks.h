// Tasks whose results every rank needs, each done by one of them.
#pragma once

#include <functional>
#include <numeric>
#include <vector>

#include "base/packing.h"
#include "paver/progress.h"
#include "paver/ranks.h"
#include "paver/result.h"

namespace paver {

/// References are kept. Takes the ranks' queues from the last one down, one per run; PartPaver from the first one up.
class SharedTasks {
 public:
  /// `threads` of this process, 0: all cores.
  SharedTasks(int threads, Progress& progress, Ranks& ranks) : threads_(threads), progress_(progress), ranks_(ranks) {}

  /// Collective, with the same costs everywhere: task(i) for every i, the results on all ranks. `costs` in
  /// microseconds, as far as counts tell; what costs little altogether is done by every rank for itself. `task` may run
  /// on any thread; what it throws ends the run. Results do not depend on the numbers of ranks and threads.
  template <class Result>
  std::vector<Result> run(Stage stage, const std::vector<double>& costs, const std::function<Result(int)>& task) {
    std::vector<Result> results(costs.size());
    auto keep = [&](int i) { results[i] = task(i); };
    constexpr double least_shared = 2000;  // microseconds: below, messages would take longer than they spare
    if (std::accumulate(costs.begin(), costs.end(), 0.0) < least_shared) {
      for (std::size_t i = 0; i < costs.size(); ++i) progress_.check(), keep(static_cast<int>(i));
      return results;
    }
    const std::vector<int> mine = do_mine(stage, costs, keep);
    if (ranks_.count() == 1) return results;
    Packer packer;
    packer(mine);
    for (int i : mine) packer(results[i]);
    const std::vector<std::string> all = ranks_.gather(packer.take());
    for (std::size_t rank = 0; rank < all.size(); ++rank) {
      if (static_cast<int>(rank) == ranks_.rank()) continue;
      std::vector<int> done;
      Unpacker unpacker(all[rank]);
      unpacker(done);
      for (int i : done) unpacker(results[i]);
    }
    return results;
  }

  /// Shared tasks done here so far.
  const std::vector<TaskTime>& times() const { return times_; }

 private:
  /// Numbers of the tasks done here.
  std::vector<int> do_mine(Stage stage, const std::vector<double>& costs, const std::function<void(int)>& task);

  int threads_;
  Progress& progress_;
  Ranks& ranks_;
  int queue_ = Ranks::most_queues;
  std::vector<TaskTime> times_;
};

}  // namespace paver
