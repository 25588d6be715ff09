// Shares that went through bytes make the whole result again, bit for bit.
#include <gtest/gtest.h>

#include <cstring>

#include "paver/mesher.h"
#include "paver/output.h"
#include "support/deal_shares.h"
#include "support/folders.h"

namespace paver {
namespace {

MeshResult mesh_example(const char* name, double size, int order) {
  Options options;
  options.size = size;
  options.order = order;
  Progress progress;
  return mesh_file(test::examples_folder() / name, options, progress);
}

/// Bit for bit.
template <class T>
bool is_same(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const MeshResult& a, const MeshResult& b) {
  EXPECT_EQ(report_json(a), report_json(b));
  EXPECT_EQ(report_table(a.report), report_table(b.report));
  EXPECT_EQ(a.face_names, b.face_names);
  EXPECT_EQ(a.edge_names, b.edge_names);
  const SurfaceMesh &m = a.mesh, &n = b.mesh;
  EXPECT_EQ(m.order, n.order);
  EXPECT_TRUE(is_same(m.nodes, n.nodes) && is_same(m.node_edge, n.node_edge) && is_same(m.node_target, n.node_target));
  EXPECT_TRUE(is_same(m.quads, n.quads) && is_same(m.quad_face, n.quad_face));
  EXPECT_TRUE(is_same(m.triangles, n.triangles) && is_same(m.triangle_face, n.triangle_face));
  EXPECT_TRUE(is_same(m.lines, n.lines) && is_same(m.line_edge, n.line_edge));
  EXPECT_TRUE(is_same(m.further_edges, n.further_edges));
}

TEST(PackResult, AResultIsTheSameAfterwards) {
  MeshResult result = mesh_example("box_cylinder.step", 20, 2);
  result.report.faces[1].where = Vec3{1, 2, 3};
  expect_same(unpack_result(pack_result(result)), result);
}

TEST(PackResult, SharesInAnyOrderMakeTheWhole) {
  for (int order : {1, 2})
    for (int ranks : {1, 2, 5}) {
      MeshResult whole = mesh_example("wing.step", 20, order), found;
      std::vector<MeshShare> shares = test::deal_shares(whole, ranks, 7);
      for (auto share = shares.rbegin(); share != shares.rend(); ++share)
        add_share(unpack_share(pack_share(*share)), found);
      SCOPED_TRACE("order " + std::to_string(order) + ", ranks " + std::to_string(ranks));
      expect_same(found, whole);
    }
}

TEST(PackResult, BytesThatEndEarlyAreAnError) {
  std::string bytes = pack_result(mesh_example("box.step", 20, 1));
  for (std::size_t size : {std::size_t(0), std::size_t(3), bytes.size() / 2, bytes.size() - 1})
    EXPECT_THROW(unpack_result(std::string_view(bytes).substr(0, size)), Error);
}

}  // namespace
}  // namespace paver
