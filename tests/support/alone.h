// Stages that share their work between ranks, called by a process on its own.
#pragma once

#include "base/tasks/shared_tasks.h"

namespace paver::test {

class Alone {
 public:
  explicit Alone(Progress& progress) : tasks_(1, progress, rank_) {}
  operator SharedTasks&() { return tasks_; }

 private:
  SingleRank rank_;
  SharedTasks tasks_;
};

}  // namespace paver::test
