#include "base/tasks/stage_clock.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace paver {
namespace {

/// Its entry in a list by stages, zero at first.
template <class T>
T& of_stage(std::vector<std::pair<std::string, T>>& list, Stage stage) {
  auto known = std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.first == stage_name(stage); });
  return known != list.end() ? known->second : list.emplace_back(stage_name(stage), T()).second;
}

}  // namespace

void StageClock::begin(Stage stage) {
  if (stage == stage_) return;
  end();
  ++of_stage(report_.stage_runs, stage);
  progress_.begin(stage, 1);
  stage_ = stage;
  started_ = Clock::now();
}

void StageClock::end() {
  if (stage_ == Stage::done) return;
  of_stage(report_.stage_seconds, stage_) += std::chrono::duration<double>(Clock::now() - started_).count();
  stage_ = Stage::done;
}

}  // namespace paver
