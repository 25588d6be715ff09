#include "base/tasks/shared_tasks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <numeric>

#include "support/thread_ranks.h"

namespace paver {
namespace {

constexpr double dear = 1000, cheap = 0.1;

std::string text_of(int i) { return std::string(static_cast<std::size_t>(i % 5), 'x') + std::to_string(i); }

std::vector<std::string> all_texts(int count) {
  std::vector<std::string> texts;
  for (int i = 0; i < count; ++i) texts.push_back(text_of(i));
  return texts;
}

TEST(SharedTasks, EveryRankHasAllResults) {
  for (int count : {1, 2, 3, 8})
    for (double cost : {dear, cheap})
      for (int tasks : {0, 1, 50}) {
        test::run_on_ranks(count, [&](Ranks& ranks) {
          Progress progress;
          SharedTasks shared(2, progress, ranks);
          const std::vector<double> costs(static_cast<std::size_t>(tasks), cost);
          EXPECT_EQ(shared.run<std::string>(Stage::boundary, costs, text_of), all_texts(tasks));
          EXPECT_EQ(shared.run<int>(Stage::boundary, costs, [](int i) { return i; }).size(), costs.size());
        });
      }
}

TEST(SharedTasks, DearTasksAreDoneOnceAndTimed) {
  std::vector<std::atomic<int>> runs(40);
  std::atomic<std::size_t> timed{0};
  test::run_on_ranks(3, [&](Ranks& ranks) {
    Progress progress;
    SharedTasks shared(1, progress, ranks);
    shared.run<int>(Stage::topology, std::vector<double>(runs.size(), dear),
                    [&](int i) { return ++runs[static_cast<std::size_t>(i)]; });
    timed += shared.times().size();
    for (const TaskTime& time : shared.times()) EXPECT_EQ(time.stage, Stage::topology);
  });
  for (const auto& count : runs) EXPECT_EQ(count.load(), 1);
  EXPECT_EQ(timed.load(), runs.size());
}

TEST(SharedTasks, CheapTasksAreDoneByEveryRank) {
  std::atomic<int> runs{0};
  test::run_on_ranks(3, [&](Ranks& ranks) {
    Progress progress;
    SharedTasks shared(1, progress, ranks);
    shared.run<int>(Stage::topology, std::vector<double>(10, cheap), [&](int) { return ++runs; });
    EXPECT_TRUE(shared.times().empty());
  });
  EXPECT_EQ(runs.load(), 30);
}

TEST(SharedTasks, WhatATaskThrowsEndsTheRun) {
  SingleRank alone;
  Progress progress;
  SharedTasks shared(2, progress, alone);
  for (double cost : {dear, cheap}) {
    EXPECT_THROW(shared.run<int>(Stage::boundary, std::vector<double>(10, cost),
                                 [](int) -> int { throw Error(ErrorCode::internal, "no"); }),
                 Error);
  }
  progress.cancel();
  EXPECT_THROW(shared.run<int>(Stage::boundary, std::vector<double>(10, cheap), [](int i) { return i; }), Error);
}

}  // namespace
}  // namespace paver
