// Any number of ranks and threads makes the mesh that one makes, bit for bit.
#include <gtest/gtest.h>

#include "paver/mesher.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

struct Case {
  const char* model;
  double size;
  int multilevel;
  int order = 2;
  Elements elements = Elements::quad_dominant;
};

CadModel read(const std::string& name) {
  Progress progress;
  return read_file(PAVER_EXAMPLES "/" + name, progress);
}

Options options_of(const Case& c, int threads) {
  Options options;
  options.size = c.size;
  options.multilevel = c.multilevel;
  options.order = c.order;
  options.elements = c.elements;
  options.threads = threads;
  return options;
}

/// Puts the shares together as their numbers say; every node must be owned once and be at one place.
SurfaceMesh put_together(const std::vector<MeshShare>& shares) {
  SurfaceMesh whole;
  const SurfaceMesh& first = shares[0].result.mesh;
  whole.order = first.order;
  for (int node : first.lines)
    whole.lines.push_back(static_cast<int>(shares[0].node_number[static_cast<std::size_t>(node)]));
  whole.line_edge = first.line_edge;
  whole.nodes.resize(static_cast<std::size_t>(shares[0].nodes));
  whole.quads.resize(static_cast<std::size_t>(shares[0].quads * first.nodes_per_quad()));
  whole.quad_face.resize(static_cast<std::size_t>(shares[0].quads));
  whole.triangles.resize(static_cast<std::size_t>(shares[0].triangles * first.nodes_per_triangle()));
  whole.triangle_face.resize(static_cast<std::size_t>(shares[0].triangles));
  std::vector<int> owners(whole.nodes.size(), 0);
  for (const MeshShare& share : shares) {
    const SurfaceMesh& mesh = share.result.mesh;
    EXPECT_EQ(share.node_number.size(), mesh.nodes.size());
    EXPECT_TRUE(std::is_sorted(share.node_number.begin(), share.node_number.end()));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      whole.nodes[static_cast<std::size_t>(share.node_number[i])] = mesh.nodes[i];
      owners[static_cast<std::size_t>(share.node_number[i])] += share.is_own_node[i];
    }
  }
  EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), static_cast<long>(owners.size()));
  auto copy = [&](const MeshShare& share, const std::vector<long>& numbers, const std::vector<int>& elements,
                  const std::vector<int>& faces, int stride, std::vector<int>& to, std::vector<int>& to_faces) {
    ASSERT_EQ(numbers.size(), faces.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      to_faces[static_cast<std::size_t>(numbers[i])] = faces[i];
      for (int k = 0; k < stride; ++k) {
        const long node = share.node_number[static_cast<std::size_t>(
            elements[i * static_cast<std::size_t>(stride) + static_cast<std::size_t>(k)])];
        to[static_cast<std::size_t>(numbers[i] * stride + k)] = static_cast<int>(node);
      }
    }
  };
  for (const MeshShare& share : shares) {
    const SurfaceMesh& mesh = share.result.mesh;
    copy(share, share.quad_number, mesh.quads, mesh.quad_face, mesh.nodes_per_quad(), whole.quads, whole.quad_face);
    copy(share, share.triangle_number, mesh.triangles, mesh.triangle_face, mesh.nodes_per_triangle(), whole.triangles,
         whole.triangle_face);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)  // all copies of a node are at one place
      EXPECT_EQ(norm(whole.nodes[static_cast<std::size_t>(share.node_number[i])] - mesh.nodes[i]), 0)
          << share.node_number[i] << " of " << share.nodes;
  }
  return whole;
}

void expect_same(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  EXPECT_TRUE(a.nodes == b.nodes);
  EXPECT_TRUE(a.quads == b.quads && a.quad_face == b.quad_face);
  EXPECT_TRUE(a.triangles == b.triangles && a.triangle_face == b.triangle_face);
  EXPECT_TRUE(a.lines == b.lines && a.line_edge == b.line_edge);
}

void expect_same_on_all(const Case& c) {
  const CadModel model = read(c.model);
  Progress progress;
  const MeshResult alone = mesh_model(model, options_of(c, 1), progress);
  EXPECT_GT(alone.mesh.quad_count() + alone.mesh.triangle_count(), 0u);
  expect_same(mesh_model(model, options_of(c, 2), progress).mesh, alone.mesh);
  for (int count : {1, 2, 3, 5}) {
    std::vector<MeshShare> shares(static_cast<std::size_t>(count));
    test::run_on_ranks(count, [&](Ranks& ranks) {
      Progress own;
      shares[static_cast<std::size_t>(ranks.rank())] = mesh_share(model, options_of(c, count == 3 ? 2 : 1), own, ranks);
    });
    SCOPED_TRACE(count);
    if (count == 1) {
      expect_same(shares[0].result.mesh, alone.mesh);
      continue;
    }
    expect_same(put_together(shares), alone.mesh);
    for (const MeshShare& share : shares) {
      EXPECT_EQ(share.result.report.notes, alone.report.notes);
      for (std::size_t f = 0; f < alone.report.faces.size(); ++f)
        EXPECT_EQ(share.result.report.faces[f].status, alone.report.faces[f].status);
    }
  }
}

TEST(Shares, OfAModelOfSeveralFaces) { expect_same_on_all({"box_cylinder.step", 5, 0}); }
TEST(Shares, OfOrderOne) { expect_same_on_all({"wing.step", 20, 0, 1}); }
TEST(Shares, OfTriangles) { expect_same_on_all({"box_cylinder.step", 6, 0, 2, Elements::all_triangle}); }
TEST(Shares, OfAClosedFaceInPatches) { expect_same_on_all({"sphere.step", 8, 0}); }
TEST(Shares, OfATorusWithCuts) { expect_same_on_all({"torus.step", 12, 0}); }
TEST(Shares, OfOneFaceOnLevels) { expect_same_on_all({"plate_circular_hole.step", 1, 4}); }
TEST(Shares, OfAPoleOnLevels) { expect_same_on_all({"conesphere_gap.step", 0.8, 4}); }

}  // namespace
}  // namespace paver
