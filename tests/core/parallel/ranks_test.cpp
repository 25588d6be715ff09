// The ranks of the tests behave as paver/ranks.h says.
#include "paver/ranks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "base/tasks/gather.h"
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

TEST(ThreadRanks, FindLeastGivesTheLeastOfEachValue) {
  run_on_ranks(3, [](Ranks& ranks) {
    std::vector<double> values{1.0 * ranks.rank(), -1.0 * ranks.rank(), INFINITY};
    ranks.find_least(values);
    EXPECT_EQ(values, (std::vector<double>{0, -2, INFINITY}));
    ranks.find_least({});
  });
}

TEST(Gather, BoxesOfAllRanksBecomeOne) {
  run_on_ranks(3, [](Ranks& ranks) {
    const double r = ranks.rank();
    std::vector<Box> boxes(3);
    boxes[0].add(Vec3{r, -r, 1});
    if (ranks.rank() == 1) boxes[1].add(Vec3{4, 5, 6});
    unite(boxes, ranks);
    EXPECT_EQ(boxes[0].low, (Vec3{0, -2, 1}));
    EXPECT_EQ(boxes[0].high, (Vec3{2, 0, 1}));
    EXPECT_EQ(boxes[1].low, (Vec3{4, 5, 6})) << "ranks without a part add nothing";
    EXPECT_EQ(boxes[1].high, (Vec3{4, 5, 6}));
    EXPECT_TRUE(boxes[2].is_empty());
    EXPECT_EQ(greatest(-r - 1, ranks), -1);
  });
}

TEST(Gather, ValuesGoToAllRanks) {
  run_on_ranks(3, [](Ranks& ranks) {
    const std::vector<std::string> mine{"all", std::to_string(ranks.rank())};
    EXPECT_EQ(gather_all(mine, ranks), (std::vector<std::string>{"all", "0", "all", "1", "all", "2"}));
  });
}

TEST(Deal, EachValueGoesToTheRankOfItsNumber) {
  run_on_ranks(3, [](Ranks& ranks) {
    const long rank = ranks.rank();
    const std::vector<long> mine{rank, 10 + rank, 20};
    const std::vector<long> here = deal(mine, ranks, [](long value) { return value; });
    std::vector<long> expected;
    for (long from = 0; from < 3; ++from)
      for (long value : {from, 10 + from, 20L})
        if (value % 3 == rank) expected.push_back(value);
    EXPECT_EQ(here, expected);
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

TEST(RowNumbers, KnowTheirRows) {
  SurfaceMesh mesh;
  mesh.nodes.resize(3);
  const ShareNumbers whole = whole_numbers(mesh);
  EXPECT_EQ(whole.node_number[2], 2);
  EXPECT_EQ(whole.node_number.row_of(2), 2);
  EXPECT_EQ(whole.node_number.row_of(3), -1);
  EXPECT_TRUE(whole.is_own(2) && !whole.is_shared(2));
  const RowNumbers some{{4, 7, 9}};
  EXPECT_EQ(some[1], 7);
  EXPECT_EQ(some.row_of(7), 1);
  EXPECT_EQ(some.row_of(5), -1);
  EXPECT_EQ(RowNumbers().row_of(0), -1) << "a share without rows";
}

TEST(DealShares, MakeUpTheWholeMesh) {
  MeshResult whole = fake::WavyMesh(2, 9, 0.1).result();
  const SurfaceMesh& mesh = whole.mesh;
  std::vector<int> owners(mesh.nodes.size(), 0), quads(mesh.quad_count(), 0), triangles(mesh.triangle_count(), 0);
  for (const MeshShare& share : test::deal_shares(whole, 3, 5)) {
    const SurfaceMesh& part = share.result.mesh;
    EXPECT_TRUE(std::ranges::is_sorted(share.node_number.list));
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      EXPECT_EQ(part.nodes[i], mesh.nodes[share.node_number[i]]);
      owners[share.node_number[i]] += share.is_own_node[i];
    }
    for (long q : share.quad_number.list) ++quads[q];
    for (long t : share.triangle_number.list) ++triangles[t];
    for (std::size_t i = 0; i < part.quads.size(); ++i)
      EXPECT_EQ(share.node_number[part.quads[i]], mesh.quads[share.quad_number[i / 9] * 9 + static_cast<long>(i % 9)]);
    for (std::size_t i = 0; i < part.lines.size(); ++i) EXPECT_EQ(share.node_number[part.lines[i]], mesh.lines[i]);
  }
  for (const auto& counts : {owners, quads, triangles})
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), static_cast<long>(counts.size()));
}

}  // namespace
}  // namespace paver
