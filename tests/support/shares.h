// The mesh that several ranks made, put together again.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "paver/mesher.h"
#include "support/thread_ranks.h"

namespace paver::test {

/// Puts the shares together as their numbers say; every node must be owned once and be at one place.
inline SurfaceMesh put_together(const std::vector<MeshShare>& shares) {
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
    EXPECT_EQ(share.node_number.list.size(), shares.size() > 1 ? mesh.nodes.size() : 0);
    EXPECT_TRUE(std::ranges::is_sorted(share.node_number.list));
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      whole.nodes[static_cast<std::size_t>(share.node_number[i])] = mesh.nodes[i];
      owners[static_cast<std::size_t>(share.node_number[i])] += share.is_own(i);
    }
  }
  EXPECT_EQ(std::count(owners.begin(), owners.end(), 1), static_cast<long>(owners.size()));
  auto copy = [&](const MeshShare& share, const RowNumbers& numbers, const std::vector<int>& elements,
                  const std::vector<int>& faces, int stride, std::vector<int>& to, std::vector<int>& to_faces) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
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

inline void expect_same(const SurfaceMesh& a, const SurfaceMesh& b) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  EXPECT_TRUE(a.nodes == b.nodes);
  EXPECT_TRUE(a.quads == b.quads && a.quad_face == b.quad_face);
  EXPECT_TRUE(a.triangles == b.triangles && a.triangle_face == b.triangle_face);
  EXPECT_TRUE(a.lines == b.lines && a.line_edge == b.line_edge);
}

/// Meshes on `count` ranks, `threads` each.
inline std::vector<MeshShare> mesh_on_ranks(const CadModel& model, Options options, int count, int threads) {
  std::vector<MeshShare> shares(static_cast<std::size_t>(count));
  options.threads = threads;
  run_on_ranks(count, [&](Ranks& ranks) {
    Progress progress;
    shares[static_cast<std::size_t>(ranks.rank())] = mesh_share(model, options, progress, ranks);
  });
  return shares;
}

/// Mesh and report must be the same on all ranks as on one.
inline void expect_same_on_ranks(const CadModel& model, const Options& options, const MeshResult& alone, int count,
                                 int threads) {
  SCOPED_TRACE(count);
  const std::vector<MeshShare> shares = mesh_on_ranks(model, options, count, threads);
  expect_same(put_together(shares), alone.mesh);
  for (const MeshShare& share : shares) {
    const RunReport& report = share.result.report;
    EXPECT_EQ(report.notes, alone.report.notes);
    EXPECT_EQ(report.quality.length_cv, alone.report.quality.length_cv);
    EXPECT_EQ(report.quality.sj_all.mean, alone.report.quality.sj_all.mean);
    EXPECT_EQ(report.quality.irregular_nodes, alone.report.quality.irregular_nodes);
    EXPECT_EQ(report.quality.border_edges, alone.report.quality.border_edges);
    EXPECT_EQ(report.quality.distance.largest, alone.report.quality.distance.largest);
    EXPECT_EQ(report.quality.distance.mean, alone.report.quality.distance.mean);
    EXPECT_EQ(report.quality.distance.angle, alone.report.quality.distance.angle);
    ASSERT_EQ(report.faces.size(), alone.report.faces.size());
    for (std::size_t f = 0; f < report.faces.size(); ++f) {
      EXPECT_EQ(report.faces[f].status, alone.report.faces[f].status);
      EXPECT_EQ(report.faces[f].reason, alone.report.faces[f].reason);
      EXPECT_EQ(report.faces[f].quads, alone.report.faces[f].quads);
      EXPECT_EQ(report.faces[f].mesh_area, alone.report.faces[f].mesh_area);
    }
  }
}

}  // namespace paver::test
