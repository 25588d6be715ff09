// Dynamic queue of tasks, largest first: each thread takes the next one when it is done with the last.
#include "parallel/tasks.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <numeric>

namespace paver {

int thread_count(int threads) { return threads > 0 ? threads : tbb::this_task_arena::max_concurrency(); }

void run_tasks(int threads, const std::vector<double>& cost, const std::function<void(int)>& task) {
  std::vector<int> order(cost.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return cost[a] > cost[b]; });
  int workers = thread_count(threads);
  std::atomic<std::size_t> next{0};
  tbb::task_arena arena(workers);
  arena.execute([&] {
    tbb::task_group_context context;  // knows when another thread's task has thrown
    tbb::parallel_for(
        0, workers,
        [&](int) {
          for (std::size_t i; (i = next.fetch_add(1)) < order.size();) {
            if (context.is_group_execution_cancelled()) return;
            task(order[i]);
          }
        },
        tbb::simple_partitioner{}, context);
  });
}

}  // namespace paver
