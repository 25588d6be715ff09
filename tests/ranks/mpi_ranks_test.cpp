// The interface Ranks as MPI serves it; run by mpirun with several numbers of ranks.
#include "worker/mpi_ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace paver {
namespace {

/// Of a length that differs between ranks, with a zero byte, and empty at some.
std::string message(int rank) {
  std::string text(static_cast<std::size_t>(37 * rank % 100), static_cast<char>('a' + rank % 26));
  return rank % 3 == 1 ? std::string() : text + '\0' + std::to_string(rank);
}

class MpiRanksTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  void TearDown() override { ranks_.finish(); }

  Progress progress_;
  MpiRanks ranks_{progress_, GetParam()};
};

TEST_P(MpiRanksTest, GatherGivesWhatEachRankGave) {
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> all = ranks_.gather(message(ranks_.rank() + round));
    ASSERT_EQ(all.size(), static_cast<std::size_t>(ranks_.count()));
    for (int r = 0; r < ranks_.count(); ++r) EXPECT_EQ(all[static_cast<std::size_t>(r)], message(r + round));
  }
}

TEST_P(MpiRanksTest, ExchangeGivesWhatEachRankHasForThisOne) {
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> mine;
    for (int to = 0; to < ranks_.count(); ++to) mine.push_back(message(ranks_.rank() + 2 * to + round));
    const std::vector<std::string> theirs = ranks_.exchange(mine);
    ASSERT_EQ(theirs.size(), mine.size());
    for (int from = 0; from < ranks_.count(); ++from)
      EXPECT_EQ(theirs[static_cast<std::size_t>(from)], message(from + 2 * ranks_.rank() + round));
  }
  const std::vector<std::string> nothing(static_cast<std::size_t>(ranks_.count()));
  EXPECT_EQ(ranks_.exchange(nothing), nothing);
}

TEST_P(MpiRanksTest, AddUpSumsEveryValue) {
  std::vector<long> values(11);
  std::iota(values.begin(), values.end(), 1000L * ranks_.rank());
  ranks_.add_up(values);
  long n = ranks_.count();
  for (long i = 0; i < 11; ++i) EXPECT_EQ(values[static_cast<std::size_t>(i)], n * i + 1000 * n * (n - 1) / 2);
  ranks_.add_up({});
}

TEST_P(MpiRanksTest, FindLeastGivesTheLeastOfEveryValue) {
  std::vector<double> values(11);
  std::iota(values.begin(), values.end(), 1000.0 * ranks_.rank());
  values.back() = -ranks_.rank();
  ranks_.find_least(values);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(values[static_cast<std::size_t>(i)], i);
  EXPECT_EQ(values.back(), 1 - ranks_.count());
  ranks_.find_least({});
}

TEST_P(MpiRanksTest, SpreadGivesWhatRank0Has) {
  for (std::string text : {std::string(), std::string("x"), std::string(1000, 'y') + '\0'}) {
    std::string mine = ranks_.rank() == 0 ? text : "other";
    ranks_.spread(mine);
    EXPECT_EQ(mine, text);
  }
}

TEST_P(MpiRanksTest, EachNumberOfAQueueIsTakenOnceWhileOthersGather) {
  constexpr int threads = 3;
  constexpr long numbers = 500;
  std::vector<std::vector<long>> taken(threads);
  std::vector<std::thread> takers;
  for (int t = 0; t < threads; ++t)
    takers.emplace_back([&, t] {
      for (long number; (number = ranks_.take(7)) < numbers;) taken[static_cast<std::size_t>(t)].push_back(number);
    });
  for (int round = 0; round < 50; ++round) ranks_.gather(message(round));
  for (std::thread& taker : takers) taker.join();
  std::string bytes;
  for (const std::vector<long>& list : taken)
    bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(long));
  std::vector<long> all;
  for (const std::string& part : ranks_.gather(bytes)) {
    std::size_t before = all.size();
    all.resize(before + part.size() / sizeof(long));
    if (!part.empty()) std::memcpy(all.data() + before, part.data(), part.size());
  }
  std::sort(all.begin(), all.end());
  std::vector<long> expected(numbers);
  std::iota(expected.begin(), expected.end(), 0);
  EXPECT_EQ(all, expected);
  EXPECT_EQ(ranks_.gather("").size(), static_cast<std::size_t>(ranks_.count()));
  long first = ranks_.is_first() ? 1 : 0;
  ranks_.add_up({&first, 1});
  EXPECT_EQ(first, 1);
}

INSTANTIATE_TEST_SUITE_P(InOnePieceAndInSmallOnes, MpiRanksTest, ::testing::Values(std::size_t(1) << 30, 16));

}  // namespace
}  // namespace paver

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
  ::testing::InitGoogleTest(&argc, argv);
  int failed = RUN_ALL_TESTS();
  MPI_Finalize();
  return failed;
}
