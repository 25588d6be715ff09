#include "base/tasks/tasks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "paver/error.h"

namespace paver {
namespace {

TEST(RunTasks, RunsEachTaskOnce) {
  for (int threads : {0, 1, 2, 7}) {
    std::vector<double> cost(500);
    for (std::size_t i = 0; i < cost.size(); ++i) cost[i] = static_cast<double>((i * 37) % 101);
    std::vector<std::atomic<int>> runs(cost.size());
    run_tasks(threads, cost, [&](int i) { ++runs[static_cast<std::size_t>(i)]; });
    for (const auto& count : runs) EXPECT_EQ(count.load(), 1);
  }
}

TEST(RunTasks, TakesTheDearestFirstAndEqualOnesInOrder) {
  std::vector<int> order;
  run_tasks(1, {1, 5, 3, 5, 0}, [&](int i) { order.push_back(i); });
  EXPECT_EQ(order, (std::vector<int>{1, 3, 2, 0, 4}));
}

TEST(RunTasks, NothingToDoIsNoError) {
  run_tasks(2, {}, [](int) { FAIL(); });
}

TEST(RunTasks, AnExceptionStopsTheRestAndComesOut) {
  for (int threads : {1, 2, 4}) {
    std::atomic<int> runs{0};
    auto task = [&](int i) {
      ++runs;
      if (i == 3) throw Error(ErrorCode::cancelled, "Cancelled; nothing was written.");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    try {
      run_tasks(threads, std::vector<double>(2000, 1), task);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::cancelled);
    }
    EXPECT_LT(runs.load(), 1000);
  }
}

TEST(RunTasks, MayBeUsedAgainAfterAnException) {
  EXPECT_THROW(run_tasks(2, {1, 1}, [](int) { throw std::runtime_error("x"); }), std::runtime_error);
  std::atomic<int> runs{0};
  run_tasks(2, {1, 1}, [&](int) { ++runs; });
  EXPECT_EQ(runs.load(), 2);
}

TEST(RunStretches, CoverEveryNumberOnce) {
  for (std::size_t count : {0, 1, 10, 11}) {
    std::vector<int> runs(count, 0);
    run_stretches(count, 5, [&](std::size_t begin, std::size_t end) {
      EXPECT_LE(end - begin, 5u);
      for (std::size_t i = begin; i < end; ++i) ++runs[i];
    });
    EXPECT_EQ(runs, std::vector<int>(count, 1));
  }
  auto fail = [](std::size_t, std::size_t) { throw std::runtime_error("no"); };
  EXPECT_THROW(run_stretches(3, 1, fail), std::runtime_error);
}

TEST(ThreadCount, ZeroStandsForAllCores) {
  EXPECT_EQ(thread_count(3), 3);
  EXPECT_GE(thread_count(0), 1);
}

}  // namespace
}  // namespace paver
