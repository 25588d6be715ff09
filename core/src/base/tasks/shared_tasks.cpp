#include "base/tasks/shared_tasks.h"

#include <numeric>

#include "base/tasks/tasks.h"

namespace paver {
namespace {

constexpr double least_shared = 2000;  // microseconds: below, messages would take longer than they spare

}  // namespace

bool SharedTasks::is_worth_sharing(const std::vector<double>& costs) {
  return std::accumulate(costs.begin(), costs.end(), 0.0) >= least_shared;
}

void SharedTasks::do_all(std::size_t tasks, const std::function<void(int)>& task) const {
  for (std::size_t i = 0; i < tasks; ++i) {
    progress_.check();
    task(static_cast<int>(i));
  }
}

std::vector<int> SharedTasks::do_mine(Stage stage, const std::vector<double>& costs,
                                      const std::function<void(int)>& task) {
  const int queue = --queue_;
  const std::vector<DoneTask> done = run_tasks(
      threads_, costs, [&] { return ranks_.take(queue); },
      [&](int i) {
        progress_.check();
        task(i);
      });
  std::vector<int> mine;
  for (const DoneTask& one : done) {
    mine.push_back(one.task);
    times_.push_back({stage, one.seconds});
  }
  return mine;
}

}  // namespace paver
