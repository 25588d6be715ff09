#include "mesh/spatial_order.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <set>

namespace paver {
namespace {

/// n x n nodes numbered row by row, quads between, less one; the node at (i, j) has i + n j as its global number.
RegionMesh rows(int n) {
  RegionMesh mesh;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = i, y = j;
      mesh.global[mesh.add_node({x, y}, {x, y, 0}, {1, 0, 0}, {0, 1, 0}, 1 + x)] = i + n * j;
    }
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) mesh.add_element({i + n * j, i + 1 + n * j, i + 1 + n * (j + 1), i + n * (j + 1)});
  mesh.remove_element(3);
  return mesh;
}

std::multiset<std::array<int, 4>> elements_by_global(const RegionMesh& mesh) {
  std::multiset<std::array<int, 4>> all;
  for (const Element& e : mesh.elements)
    if (e.is_alive()) all.insert({mesh.global[e.v[0]], mesh.global[e.v[1]], mesh.global[e.v[2]], mesh.global[e.v[3]]});
  return all;
}

TEST(OrderSpatially, OnlyNumbersChange) {
  const int n = 12;
  RegionMesh mesh = rows(n);
  const RegionMesh before = mesh;
  const std::vector<int> number = order_spatially(mesh);
  EXPECT_EQ(std::set<int>(number.begin(), number.end()).size(), before.p.size());
  for (int i = 0; i < before.node_count(); ++i) {
    EXPECT_EQ(mesh.p[number[i]], before.p[i]);
    EXPECT_EQ(mesh.h[number[i]], before.h[i]);
    EXPECT_EQ(mesh.global[number[i]], before.global[i]);
    EXPECT_EQ(mesh.star[number[i]].size(), before.star[i].size());
  }
  EXPECT_EQ(elements_by_global(mesh), elements_by_global(before));
  EXPECT_EQ(mesh.elements.size(), before.elements.size() - 1);  // no gap
  for (int i = 0; i < mesh.node_count(); ++i)
    for (int e : mesh.star[i]) EXPECT_GE(mesh.elements[e].corner_of(i), 0);
}

TEST(OrderSpatially, NeighboursAreNearEachOther) {
  const int n = 64;
  auto far_share = [](const RegionMesh& mesh) {
    double sum = 0;
    for (const Element& e : mesh.elements)
      for (int k = 0; k < 4 && e.is_alive(); ++k) sum += std::abs(e.v[k] - e.v[(k + 1) % 4]) > 16;
    return sum / (4.0 * static_cast<double>(mesh.elements.size()));
  };
  RegionMesh mesh = rows(n);
  EXPECT_GT(far_share(mesh), 0.45);  // every other side leads to the next row
  order_spatially(mesh);
  EXPECT_LT(far_share(mesh), 0.3);
}

TEST(OrderSpatially, AMeshWithoutNodesStaysEmpty) {
  RegionMesh mesh;
  EXPECT_TRUE(order_spatially(mesh).empty());
}

}  // namespace
}  // namespace paver
