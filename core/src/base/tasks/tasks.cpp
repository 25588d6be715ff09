// Dynamic queue of tasks, largest first: each thread takes the next one when it is done with the last.
#include "base/tasks/tasks.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>

namespace paver {

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
    tbb::parallel_for(
        0, workers,
        [&](int worker) {
          for (long i; (i = take()) < static_cast<long>(order.size());) {
            if (context.is_group_execution_cancelled()) return;
            const Clock::time_point start = Clock::now();
            task(order[static_cast<std::size_t>(i)]);
            const std::chrono::duration<double> seconds = Clock::now() - start;
            done[static_cast<std::size_t>(worker)].emplace_back(i, seconds.count());
          }
        },
        tbb::simple_partitioner{}, context);
  });
  std::vector<std::pair<long, double>> all;
  for (const auto& some : done) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  std::vector<DoneTask> result;
  for (auto [i, seconds] : all) result.push_back({order[static_cast<std::size_t>(i)], seconds});
  return result;
}

}  // namespace paver
