#include "base/tasks/shared_tasks.h"

#include "base/tasks/tasks.h"

namespace paver {

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
