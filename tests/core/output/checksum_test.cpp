#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/quality/wavy_mesh.h"
#include "paver/output.h"
#include "support/deal_shares.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

SurfaceMesh wavy(int order) { return fake::WavyMesh(order, 8, 0.1).result().mesh; }

/// The same rows in another order.
void shuffle(std::vector<int>& table, std::vector<int>& owner, std::mt19937& random) {
  std::vector<std::size_t> order(owner.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random);
  std::size_t stride = table.size() / owner.size();
  std::vector<int> old_table = table, old_owner = owner;
  for (std::size_t row = 0; row < order.size(); ++row) {
    owner[row] = old_owner[order[row]];
    for (std::size_t k = 0; k < stride; ++k) table[row * stride + k] = old_table[order[row] * stride + k];
  }
}

TEST(Checksum, DoesNotDependOnTheOrderOfElementsAndNodes) {
  std::mt19937 random(1);
  for (int order = 1; order <= 4; ++order) {
    SurfaceMesh mesh = wavy(order), other = mesh;
    shuffle(other.quads, other.quad_face, random);
    shuffle(other.triangles, other.triangle_face, random);
    shuffle(other.lines, other.line_edge, random);
    EXPECT_EQ(checksum(other), checksum(mesh));
    std::reverse(other.nodes.begin(), other.nodes.end());
    int last = static_cast<int>(mesh.nodes.size()) - 1;
    for (std::vector<int>* table : {&other.quads, &other.triangles, &other.lines})
      for (int& node : *table) node = last - node;
    EXPECT_EQ(checksum(other), checksum(mesh));
  }
}

/// Element that starts at its second corner, from the lattice of its nodes.
void turn(int* nodes, ElementShape shape, int p) {
  std::vector<LatticePoint> lattice = lagrange_nodes(shape, p);
  std::vector<int> old(nodes, nodes + lattice.size());
  for (std::size_t k = 0; k < lattice.size(); ++k) {
    auto [i, j] = lattice[k];  // where the node goes: the second corner becomes the first
    LatticePoint to = shape == ElementShape::quad ? LatticePoint{j, p - i} : LatticePoint{j, p - i - j};
    nodes[std::find(lattice.begin(), lattice.end(), to) - lattice.begin()] = old[k];
  }
}

TEST(Checksum, DoesNotDependOnTheFirstCornerButOnOrientation) {
  for (int order = 1; order <= 4; ++order) {
    SurfaceMesh mesh = wavy(order);
    std::uint64_t before = checksum(mesh);
    for (int times = 0; times < 3; ++times) {
      turn(mesh.quads.data(), ElementShape::quad, order);
      turn(mesh.triangles.data(), ElementShape::triangle, order);
      EXPECT_EQ(checksum(mesh), before);
    }
    std::swap(mesh.quads[1], mesh.quads[3]);
    EXPECT_NE(checksum(mesh), before);
  }
  SurfaceMesh straight = wavy(1);
  std::vector<int> corners(straight.quads.begin(), straight.quads.begin() + 4);
  turn(straight.quads.data(), ElementShape::quad, 1);
  EXPECT_EQ(straight.quads[0], corners[1]) << "the test itself must turn";
  EXPECT_EQ(straight.quads[3], corners[0]);
}

TEST(Checksum, ChangesWithAnyPartOfTheMesh) {
  const SurfaceMesh mesh = wavy(2);
  std::set<std::uint64_t> seen{checksum(mesh)};
  std::size_t changes = 1;
  auto expect_new = [&](auto change) {
    SurfaceMesh other = mesh;
    change(other);
    seen.insert(checksum(other));
    EXPECT_EQ(seen.size(), ++changes);
  };
  for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
    expect_new([&](SurfaceMesh& m) { m.nodes[node].x = std::nextafter(m.nodes[node].x, 1e9); });
    expect_new([&](SurfaceMesh& m) { m.nodes[node].y = std::nextafter(m.nodes[node].y, -1e9); });
    expect_new([&](SurfaceMesh& m) { std::swap(m.nodes[node].y, m.nodes[node].z); });
    expect_new([&](SurfaceMesh& m) { m.nodes[node].z = -m.nodes[node].z; });
  }
  for (std::size_t quad = 0; quad < mesh.quad_face.size(); ++quad) {
    expect_new([&](SurfaceMesh& m) { m.quad_face[quad] += 2; });
    expect_new([&](SurfaceMesh& m) { m.quad_face[quad] += 1 << 20; });
  }
  for (std::size_t line = 0; line < mesh.line_edge.size(); ++line) {
    expect_new([&](SurfaceMesh& m) { m.line_edge[line] += 8; });
    expect_new([&](SurfaceMesh& m) { m.further_edges.push_back({static_cast<int>(line), m.line_edge[line]}); });
  }
  expect_new([](SurfaceMesh& m) { m.nodes.push_back(m.nodes[0]); });
  expect_new([](SurfaceMesh& m) { m.triangles.resize(m.triangles.size() - 6), m.triangle_face.pop_back(); });
}

TEST(Checksum, SeesWhichNodesMakeUpWhichElement) {
  SurfaceMesh one, other;
  for (SurfaceMesh* mesh : {&one, &other}) {
    for (int i = 0; i < 8; ++i) mesh->nodes.push_back({static_cast<double>(i % 4), static_cast<double>(i / 4), 0});
    mesh->triangle_face = {0, 0};
  }
  one.triangles = {0, 1, 4, 2, 3, 6};
  other.triangles = {0, 1, 6, 2, 3, 4};  // the same nodes all in all
  EXPECT_NE(checksum(one), checksum(other));
}

TEST(Checksum, IsSpreadOverAllBits) {
  SurfaceMesh mesh = wavy(1);
  std::array<int, 64> flips{};
  std::uint64_t before = checksum(mesh);
  constexpr int trials = 512;
  for (int i = 0; i < trials; ++i) {
    Vec3& node = mesh.nodes[static_cast<std::size_t>(i) % mesh.nodes.size()];
    node.x = std::nextafter(node.x, 1e9);
    std::uint64_t after = checksum(mesh);
    for (int bit = 0; bit < 64; ++bit) flips[static_cast<std::size_t>(bit)] += (before ^ after) >> bit & 1;
    before = after;
  }
  for (int count : flips) EXPECT_NEAR(count, trials / 2, 6 * std::sqrt(trials / 4.0));
}

TEST(Checksum, OfSharesIsThatOfTheWhole) {
  for (int order = 1; order <= 3; ++order) {
    MeshResult whole = fake::WavyMesh(order, 12, 0.2).result();
    whole.mesh.nodes.push_back({1, 2, 3});
    whole.mesh.node_edge.push_back(-1);
    whole.mesh.further_edges = {{3, 77}};
    for (int count : {1, 2, 3, 5}) {
      std::vector<MeshShare> shares = test::deal_shares(whole, count, 11);
      test::run_on_ranks(count, [&](Ranks& ranks) {
        const MeshShare& share = shares[static_cast<std::size_t>(ranks.rank())];
        EXPECT_EQ(checksum(share.result.mesh, share, ranks), checksum(whole.mesh));
      });
    }
  }
}

}  // namespace
}  // namespace paver
