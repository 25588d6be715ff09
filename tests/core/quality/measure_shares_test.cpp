// The figures of a mesh are the same for any number of ranks and threads, and those of a plain count.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <map>
#include <set>

#include "core/quality/wavy_mesh.h"
#include "paver/output.h"
#include "support/deal_shares.h"
#include "support/measure_quality.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

/// Elements between nodes drawn at random: borders, edges of many elements, nodes that nothing uses.
MeshResult soup(unsigned seed, int nodes, int elements, int order) {
  std::mt19937 random(seed);
  MeshResult result;
  SurfaceMesh& mesh = result.mesh;
  mesh.order = order;
  for (int i = 0; i < nodes; ++i) {
    auto number = [&] { return static_cast<double>(random() % 1000) / 100; };
    mesh.nodes.push_back({number(), number(), number()});
  }
  mesh.node_edge.assign(mesh.nodes.size(), -1);
  auto draw = [&](std::vector<int>& table, int count) {
    std::set<int> chosen;
    while (static_cast<int>(chosen.size()) < count) {
      int node = static_cast<int>(random() % static_cast<unsigned>(nodes));
      if (chosen.insert(node).second) table.push_back(node);
    }
  };
  for (int i = 0; i < elements; ++i) {
    bool is_quad = random() % 3 > 0;
    draw(is_quad ? mesh.quads : mesh.triangles, is_quad ? mesh.nodes_per_quad() : mesh.nodes_per_triangle());
    (is_quad ? mesh.quad_face : mesh.triangle_face).push_back(static_cast<int>(random() % 3));
  }
  for (int i = 0; i < 4; ++i) draw(mesh.lines, order + 1), mesh.line_edge.push_back(i);
  result.report.faces.resize(3);
  result.report.faces[1].cad_area = 17;
  return result;
}

const std::vector<bool> periodic{false, true, false, false, true};

/// All figures as text with every digit.
std::string text_of(const QualityReport& quality, const std::vector<FaceReport>& faces) {
  MeshResult result;
  result.report.quality = quality;
  result.report.faces = faces;
  return report_json(result);
}

std::string figures(MeshResult mesh) {
  QualityReport q = measure_quality(mesh.mesh, 3, periodic, mesh.report.faces, Progress());
  return text_of(q, mesh.report.faces);
}

void expect_same_on_ranks(const MeshResult& mesh) {
  std::string whole = figures(mesh);
  for (int count : {1, 2, 3, 5}) {
    std::vector<MeshShare> shares = test::deal_shares(mesh, count, static_cast<unsigned>(count), 40);
    test::run_on_ranks(count, [&](Ranks& ranks) {
      MeshShare& share = shares[static_cast<std::size_t>(ranks.rank())];
      QualityReport q = measure_quality(share, 3, periodic, share.result.report.faces, Progress(), ranks);
      EXPECT_EQ(text_of(q, share.result.report.faces), whole) << "rank " << ranks.rank() << " of " << count;
    });
  }
}

TEST(MeasureShares, GivesTheFiguresOfOneRankBitForBit) {
  for (int order = 1; order <= 3; ++order) {
    MeshResult mesh = fake::WavyMesh(order, 40, 0.6 / order).result();
    mesh.mesh.nodes.push_back({1e6, 1e6, 1e6});  // used by nothing
    mesh.mesh.node_edge.push_back(-1);
    expect_same_on_ranks(mesh);
  }
  expect_same_on_ranks(MeshResult{});
}

TEST(MeasureShares, DoesSoForAnyTangleOfElements) {
  for (unsigned seed = 0; seed < 20; ++seed)
    expect_same_on_ranks(soup(seed, 6 + static_cast<int>(seed) * 5, 60, 1 + static_cast<int>(seed % 3)));
}

TEST(MeasureQuality, DoesNotDependOnThreads) {
  for (const MeshResult& mesh : {fake::WavyMesh(2, 60, 0.3).result(), soup(9, 300, 4000, 1)}) {
    std::string one = tbb::task_arena(1).execute([&] { return figures(mesh); });
    for (int threads : {2, 3, 7}) {
      tbb::task_arena arena(threads);
      EXPECT_EQ(arena.execute([&] { return figures(mesh); }), one);
    }
  }
}

/// The counts of measure_quality by sets and maps, as the definitions read.
struct PlainCount {
  std::map<std::pair<int, int>, int> uses;
  std::map<int, std::set<int>> neighbours;
  std::set<int> used, outside;
  long border = 0, nonmanifold = 0, interior = 0, irregular = 0;

  explicit PlainCount(const SurfaceMesh& mesh) {
    add(mesh.quads, 4, mesh.nodes_per_quad());
    add(mesh.triangles, 3, mesh.nodes_per_triangle());
    std::size_t stride = static_cast<std::size_t>(mesh.order) + 1;
    for (std::size_t i = 0; i < mesh.lines.size(); ++i) {
      if (!periodic[static_cast<std::size_t>(mesh.line_edge[i / stride])]) outside.insert(mesh.lines[i]);
    }
    for (auto [edge, count] : uses) {
      border += count == 1;
      nonmanifold += count > 2;
      if (count == 1) outside.insert({edge.first, edge.second});
    }
    for (const auto& [node, others] : neighbours) {
      if (outside.count(node)) continue;
      ++interior;
      irregular += others.size() != 4;
    }
  }

  void add(const std::vector<int>& table, int corners, int stride) {
    used.insert(table.begin(), table.end());
    for (std::size_t at = 0; at < table.size(); at += static_cast<std::size_t>(stride)) {
      for (int k = 0; k < corners; ++k) {
        int a = table[at + static_cast<std::size_t>(k)], b = table[at + static_cast<std::size_t>((k + 1) % corners)];
        ++uses[{std::min(a, b), std::max(a, b)}];
        neighbours[a].insert(b), neighbours[b].insert(a);
      }
    }
  }
};

TEST(MeasureQuality, CountsAsItsDefinitionsRead) {
  for (unsigned seed = 100; seed < 140; ++seed) {
    MeshResult mesh = soup(seed, 8 + static_cast<int>(seed % 40), 30, 1);
    PlainCount expected(mesh.mesh);
    QualityReport q = measure_quality(mesh.mesh, 3, periodic, mesh.report.faces, Progress());
    EXPECT_EQ(q.nodes, static_cast<long>(expected.used.size()));
    EXPECT_EQ(q.border_edges, expected.border);
    EXPECT_EQ(q.nonmanifold_edges, expected.nonmanifold);
    EXPECT_EQ(q.face_interior_nodes, expected.interior);
    EXPECT_EQ(q.irregular_nodes, expected.irregular);
    double sum = 0;
    for (const auto& edge : expected.uses)
      sum += norm(mesh.mesh.nodes[edge.first.first] - mesh.mesh.nodes[edge.first.second]);
    EXPECT_NEAR(q.length_mean * 3, sum / static_cast<double>(expected.uses.size()), 1e-12);
  }
}

}  // namespace
}  // namespace paver
