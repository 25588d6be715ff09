// Dynamic queue of tasks, largest first: each thread takes the next one when it is done with the last.
#include "base/tasks/tasks.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>

namespace paver {
namespace {

/// A task sees what its caller has done, and the caller afterwards what all tasks have done. TBB promises that; it is
/// said once more as ThreadSanitizer does not see inside TBB's library. Tasks among themselves are not put in order.
class HandOver {
 public:
  HandOver() { begun.fetch_add(1, std::memory_order_release); }
  ~HandOver() { ended_.load(std::memory_order_acquire); }
  HandOver(const HandOver&) = delete;
  HandOver& operator=(const HandOver&) = delete;

  /// What TBB is to call: it reads nothing before it is in order, and is small enough to be copied without memcpy.
  template <class Work>
  static auto entering(const Work& work) {
    return [&work](auto i) {
      begun.load(std::memory_order_acquire);
      work(i);
    };
  }
  /// Made first in a task: however it ends, its caller will see it.
  struct End {
    std::atomic<long>& ended;
    ~End() { ended.fetch_add(1, std::memory_order_release); }
  };
  End end() { return {ended_}; }

 private:
  static inline std::atomic<long> begun{0};  // of all: making one for each would be an access out of order itself
  std::atomic<long> ended_{0};
};

}  // namespace

void run_in_arena(int threads, const std::function<void()>& work) {
  // More threads than cores are as many as are asked for, without a warning of the library's.
  using Control = tbb::global_control;
  const int count = thread_count(threads);
  const Control allowed(
      Control::max_allowed_parallelism,
      std::max(static_cast<std::size_t>(count), Control::active_value(Control::max_allowed_parallelism)));
  tbb::task_arena arena(count);
  arena.execute(work);
}

int thread_count(int threads) { return threads > 0 ? threads : tbb::this_task_arena::max_concurrency(); }

void run_tasks(int threads, const std::vector<double>& cost, const std::function<void(int)>& task) {
  std::atomic<long> next{0};
  auto take = [&] { return next.fetch_add(1); };
  run_tasks(threads, cost, take, task);
}

std::vector<DoneTask> run_tasks(int threads, const std::vector<double>& cost, const std::function<long()>& take,
                                const std::function<void(int)>& task) {
  std::vector<int> order(cost.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return cost[a] > cost[b]; });
  const int workers = thread_count(threads);
  using Clock = std::chrono::steady_clock;
  std::vector<std::vector<std::pair<long, double>>> done(static_cast<std::size_t>(workers));
  tbb::task_arena arena(workers);
  arena.execute([&] {
    tbb::task_group_context context;  // knows when another thread's task has thrown
    HandOver hand_over;
    const auto work = [&](int worker) {
      const auto end = hand_over.end();
      for (long i; (i = take()) < static_cast<long>(order.size());) {
        if (context.is_group_execution_cancelled()) return;
        const Clock::time_point start = Clock::now();
        task(order[i]);
        const std::chrono::duration<double> seconds = Clock::now() - start;
        done[worker].emplace_back(i, seconds.count());
      }
    };
    tbb::parallel_for(0, workers, HandOver::entering(work), tbb::simple_partitioner{}, context);
  });
  std::vector<std::pair<long, double>> all;
  for (const auto& some : done) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  std::vector<DoneTask> result;
  for (auto [i, seconds] : all) result.push_back({order[i], seconds});
  return result;
}

void run_stretches(std::size_t count, std::size_t most, const std::function<void(std::size_t, std::size_t)>& work) {
  HandOver hand_over;
  const auto stretch = [&](std::size_t i) {
    const auto end = hand_over.end();
    work(i * most, std::min((i + 1) * most, count));
  };
  tbb::parallel_for(std::size_t{0}, (count + most - 1) / most, HandOver::entering(stretch));
}

}  // namespace paver
