// Pairs of elements near each other against all pairs, on any number of ranks.
#include "check/near/near_search.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/thread_ranks.h"

namespace paver {
namespace {

/// Squares of very different sizes about the middle of space, some of them large; face: 0 or 1.
SurfaceMesh squares(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-6, 6), power(-3, 0.7);
  SurfaceMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3 x{place(random), place(random), place(random)};
    const double side = std::pow(10, power(random));
    const Vec3 a = i % 2 ? Vec3{side, 0, 0} : Vec3{0, side, 0}, b{0, 0.3 * side, side};
    for (const Vec3& node : {x, x + a, x + a + b, x + b}) {
      mesh.quads.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.push_back(node);
      mesh.node_edge.push_back(-1);
      mesh.node_target.push_back(side);
    }
    mesh.quad_face.push_back(i % 3 == 0);
  }
  return mesh;
}

/// Those of one rank; the first one is on all of them.
SurfaceMesh share_of(const SurfaceMesh& whole, int rank, int ranks) {
  SurfaceMesh share = whole;
  share.quads.clear();
  share.quad_face.clear();
  for (std::size_t i = 0; i < whole.quad_count(); ++i) {
    if (i > 0 && static_cast<int>(i * i) % ranks != rank) continue;
    share.quads.insert(share.quads.end(), &whole.quads[4 * i], &whole.quads[4 * i] + 4);
    share.quad_face.push_back(whole.quad_face[i]);
  }
  return share;
}

/// Where squares of both faces are.
struct TwoFaces {
  struct Summary {
    std::array<char, 2> is_there{};
    void add(const Summary& other) {
      for (int k = 0; k < 2; ++k) is_there[k] = is_there[k] || other.is_there[k];
    }
  };
  bool is_wanted(std::size_t) const { return true; }
  Box box(const Piece& piece) const { return piece.patch.bounds(); }
  Summary summary(const Piece& piece) const { return {{piece.face == 0, piece.face == 1}}; }
  bool is_mixed(const Summary& summary) const { return summary.is_there[0] && summary.is_there[1]; }
};

using Pair = std::array<double, 2>;  // abscissas of the first nodes, the lower first

struct FoundPairs {
  std::vector<std::pair<PairOrder, Pair>> pairs;
  void add(const FoundPairs& others) { pairs.insert(pairs.end(), others.pairs.begin(), others.pairs.end()); }
};

FoundPairs search(const SurfaceMesh& mesh, Ranks& ranks) {
  const Model model;
  const MeshPieces pieces(mesh, model, ranks);
  const TwoFaces kind;
  auto found = NearSearch(kind, pieces, ranks)
                   .run<FoundPairs>([](FoundPairs& some, const Piece& a, const Piece& b, const PairOrder& order) {
                     const double x = a.patch.nodes[0].x, y = b.patch.nodes[0].x;
                     if (a.face != b.face) some.pairs.emplace_back(order, Pair{std::min(x, y), std::max(x, y)});
                   });
  FoundPairs all{gather_all(found.pairs, ranks)};
  std::ranges::sort(all.pairs);
  return all;
}

std::set<Pair> all_pairs(const SurfaceMesh& mesh) {
  SingleRank alone;
  const Model model;
  const MeshPieces pieces(mesh, model, alone);
  std::set<Pair> pairs;
  for (std::size_t i = 0; i < pieces.count(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Piece a = pieces.piece(i), b = pieces.piece(k);
      if (a.face == b.face || !a.patch.bounds().meets(b.patch.bounds())) continue;
      const double x = a.patch.nodes[0].x, y = b.patch.nodes[0].x;
      pairs.insert({std::min(x, y), std::max(x, y)});
    }
  return pairs;
}

TEST(NearSearch, FindsEachPairOnceOnAnyNumberOfRanks) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const SurfaceMesh mesh = squares(900, seed);
    SingleRank alone;
    const FoundPairs found = search(mesh, alone);
    std::set<Pair> pairs;
    for (const auto& [order, pair] : found.pairs) EXPECT_TRUE(pairs.insert(pair).second) << "once only";
    EXPECT_EQ(pairs, all_pairs(mesh));
    EXPECT_GT(pairs.size(), 20U);
    for (int count : {2, 5})
      test::run_on_ranks(count, [&](Ranks& ranks) {
        EXPECT_EQ(search(share_of(mesh, ranks.rank(), count), ranks).pairs, found.pairs) << "in the same order";
      });
  }
}

TEST(NearSearch, NothingIsFoundWhereThereIsNothing) {
  SingleRank alone;
  EXPECT_TRUE(search({}, alone).pairs.empty());
}

}  // namespace
}  // namespace paver
