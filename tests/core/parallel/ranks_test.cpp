// The ranks of the tests behave as paver/ranks.h says.
#include "paver/ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/quality/wavy_mesh.h"
#include "support/deal_shares.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

using test::run_on_ranks;

TEST(ThreadRanks, GatherGivesAllByRank) {
  run_on_ranks(5, [](Ranks& ranks) {
    for (int round = 0; round < 50; ++round) {
      std::string mine(static_cast<std::size_t>((ranks.rank() + round) % 3), static_cast<char>('a' + ranks.rank()));
      std::vector<std::string> all = ranks.gather(mine);
      ASSERT_EQ(all.size(), 5u);
      for (int rank = 0; rank < 5; ++rank)
        EXPECT_EQ(all[rank], std::string(static_cast<std::size_t>((rank + round) % 3), static_cast<char>('a' + rank)));
    }
  });
}

TEST(ThreadRanks, AddUpSumsEachValue) {
  run_on_ranks(3, [](Ranks& ranks) {
    std::vector<long> values{ranks.rank(), 10L * ranks.rank(), -1};
    ranks.add_up(values);
    EXPECT_EQ(values, (std::vector<long>{3, 30, -3}));
    ranks.add_up({});
  });
}

TEST(ThreadRanks, TakeGivesEachNumberToOneRank) {
  std::vector<std::vector<long>> taken(4);
  run_on_ranks(4, [&](Ranks& ranks) {
    for (long number = ranks.take(7); number < 1000; number = ranks.take(7)) taken[ranks.rank()].push_back(number);
  });
  std::vector<long> all;
  for (const auto& list : taken) all.insert(all.end(), list.begin(), list.end());
  std::sort(all.begin(), all.end());
  std::vector<long> expected(1000);
  std::iota(expected.begin(), expected.end(), 0L);
  EXPECT_EQ(all, expected);
}

TEST(ThreadRanks, AnExceptionReleasesTheOthers) {
  try {
    run_on_ranks(3, [](Ranks& ranks) {
      if (ranks.rank() == 1) throw std::invalid_argument("no");
      while (true) ranks.gather("");
    });
    FAIL() << "nothing was thrown";
  } catch (const std::exception& e) {
    EXPECT_STREQ(e.what(), "no");
  }
}

TEST(ThreadRanks, CallsThatDoNotMatchAreAnError) {
  EXPECT_THROW(run_on_ranks(3, [](Ranks& ranks) { ranks.rank() == 1 ? void() : void(ranks.gather("")); }),
               std::logic_error);
  std::vector<long> values(1);
  EXPECT_THROW(run_on_ranks(2, [&](Ranks& ranks) { ranks.rank() ? ranks.add_up(values) : void(ranks.gather("")); }),
               std::logic_error);
}

TEST(DealShares, MakeUpTheWholeMesh) {
  MeshResult whole = fake::WavyMesh(2, 9, 0.1).result();
  const SurfaceMesh& mesh = whole.mesh;
  std::vector<int> owners(mesh.nodes.size(), 0), quads(mesh.quad_count(), 0), triangles(mesh.triangle_count(), 0);
  for (const MeshShare& share : test::deal_shares(whole, 3, 5)) {
    const SurfaceMesh& part = share.result.mesh;
    EXPECT_TRUE(std::is_sorted(share.node_number.begin(), share.node_number.end()));
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      EXPECT_EQ(part.nodes[i], mesh.nodes[share.node_number[i]]);
      owners[share.node_number[i]] += share.is_own_node[i];
    }
    for (long q : share.quad_number) ++quads[q];
    for (long t : share.triangle_number) ++triangles[t];
    for (std::size_t i = 0; i < part.quads.size(); ++i)
      EXPECT_EQ(share.node_number[part.quads[i]], mesh.quads[share.quad_number[i / 9] * 9 + static_cast<long>(i % 9)]);
    for (std::size_t i = 0; i < part.lines.size(); ++i) EXPECT_EQ(share.node_number[part.lines[i]], mesh.lines[i]);
  }
  for (const auto& counts : {owners, quads, triangles})
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), static_cast<long>(counts.size()));
}

}  // namespace
}  // namespace paver
