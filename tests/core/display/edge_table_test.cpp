#include "display/edge_table.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <tuple>

namespace paver {
namespace {

TEST(EdgeTable, NumbersEdgesLikeAMap) {
  std::mt19937 random(3);
  EdgeTable table(10);  // grows far beyond
  std::map<std::tuple<int, int, int>, int> wanted;
  for (int i = 0; i < 20000; ++i) {
    int a = static_cast<int>(random() % 300), b = static_cast<int>(random() % 300),
        inner = static_cast<int>(random() % 3);
    EdgeKey key = edge_key(a, b, &inner, 2);
    EXPECT_EQ(key, edge_key(b, a, &inner, 2));
    auto [found, is_new] = wanted.try_emplace({key.low, key.high, key.inner}, static_cast<int>(wanted.size()));
    EXPECT_EQ(table.find(key), is_new ? -1 : found->second);
    EXPECT_EQ(table.number(key), std::pair(found->second, is_new));
    EXPECT_EQ(table.find(key), found->second);
  }
}

TEST(EdgeTable, TellsCurvedEdgesWithTheSameEndsApart) {
  int inner[] = {7, 5, 9, 4};
  EXPECT_EQ(edge_key(3, 1, inner, 3), (EdgeKey{1, 3, 5}));
  EXPECT_EQ(edge_key(3, 1, inner + 2, 3), (EdgeKey{1, 3, 4}));
  EXPECT_EQ(edge_key(3, 1, nullptr, 1), (EdgeKey{1, 3, -1}));
}

}  // namespace
}  // namespace paver
