// Independent tasks on a pool of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace paver {

/// Runs task(i) for i = 0 .. cost.size() - 1 on `threads` threads (0: all cores), dearest first. The first exception
/// stops the rest and is thrown on. Results must go to slots of their own, so that the outcome does not depend on
/// order.
void run_tasks(int threads, const std::vector<double>& cost, const std::function<void(int)>& task);

/// A task that was done here, and its wall time.
struct DoneTask {
  int task = -1;
  double seconds = 0;
};

/// The same for a queue shared with others: each thread takes the next number from `take` until it is beyond the last
/// task. Gives those done here in the order of the queue.
std::vector<DoneTask> run_tasks(int threads, const std::vector<double>& cost, const std::function<long()>& take,
                                const std::function<void(int)>& task);

/// work(begin, end) for stretches of at most `most` of 0 .. count - 1, on the threads of the calling arena. The first
/// exception stops the rest and is thrown on.
void run_stretches(std::size_t count, std::size_t most, const std::function<void(std::size_t, std::size_t)>& work);

/// The work, in an arena of `threads` threads (0: all cores).
void run_in_arena(int threads, const std::function<void()>& work);

/// Number of threads that `threads` stands for.
int thread_count(int threads);

}  // namespace paver
