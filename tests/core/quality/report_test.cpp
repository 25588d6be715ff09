#include "quality/report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/quality/wavy_mesh.h"
#include "support/measure_quality.h"

namespace paver {
namespace {

/// The surface of a unit cube: six quads, one per face, edges numbered as they come.
MeshResult cube() {
  MeshResult result;
  SurfaceMesh& mesh = result.mesh;
  for (int i = 0; i < 8; ++i) mesh.nodes.push_back({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
  mesh.quads = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  mesh.quad_face = {0, 1, 2, 3, 4, 5};
  mesh.lines = {0, 1, 1, 3, 3, 2, 2, 0, 4, 5, 5, 7, 7, 6, 6, 4, 0, 4, 1, 5, 3, 7, 2, 6};
  for (int i = 0; i < 12; ++i) mesh.line_edge.push_back(i);
  mesh.node_edge.assign(8, 0);
  result.report.faces.resize(6);
  for (FaceReport& face : result.report.faces) face.cad_area = 1;
  return result;
}

QualityReport measure(MeshResult& result, double h, bool is_periodic = false) {
  return measure_quality(result.mesh, h, std::vector<bool>(12, is_periodic), result.report.faces, Progress());
}

TEST(MeasureQuality, OfACubeIsPerfectAndWatertight) {
  MeshResult result = cube();
  QualityReport q = measure(result, 2);
  EXPECT_EQ(q.quads, 6);
  EXPECT_EQ(q.nodes, 8);
  EXPECT_TRUE(q.watertight);
  EXPECT_NEAR(q.sj_all.min, 1, 1e-15);
  EXPECT_NEAR(q.mesh_area, 6, 1e-12);
  EXPECT_NEAR(q.cad_area, 6, 1e-12);
  EXPECT_NEAR(q.length_mean, 0.5, 1e-15);
  EXPECT_EQ(q.length_in_band, 0);
  EXPECT_EQ(q.face_interior_nodes, 0);
  EXPECT_NEAR(q.min_jacobian_ratio, 1, 1e-12);
  for (const FaceReport& face : result.report.faces) EXPECT_EQ(face.quads, 1);
}

TEST(MeasureQuality, CountsNodesOnPeriodicEdgesAsInside) {
  MeshResult result = cube();
  QualityReport q = measure(result, 1, true);
  EXPECT_EQ(q.face_interior_nodes, 8);
  EXPECT_EQ(q.irregular_nodes, 8);
  EXPECT_EQ(q.length_in_band, 1);
}

TEST(MeasureQuality, SeesBordersAndEdgesOfThreeElements) {
  MeshResult result = cube();
  SurfaceMesh& mesh = result.mesh;
  mesh.quads.resize(20), mesh.quad_face.resize(5);
  EXPECT_EQ(measure(result, 1).border_edges, 4);
  EXPECT_EQ(result.report.faces[5].longest_side, 0);
  EXPECT_FALSE(std::signbit(result.report.faces[5].longest_side));
  mesh.triangles = {0, 3, 1};
  mesh.triangle_face = {0};
  QualityReport q = measure(result, 1);
  EXPECT_EQ(q.triangles, 1);
  EXPECT_FALSE(q.watertight);
  EXPECT_EQ(q.nonmanifold_edges, 1);
}

TEST(MeasureQuality, CreditsEachFaceWithItsOwn) {
  MeshResult result = fake::WavyMesh(2, 10, 0.4).result();
  QualityReport q = measure(result, 10);
  const FaceReport &left = result.report.faces[0], &right = result.report.faces[1];
  EXPECT_EQ(left.quads + right.quads, q.quads);
  EXPECT_EQ(left.triangles + right.triangles, q.triangles);
  EXPECT_NEAR(left.mesh_area + right.mesh_area, q.mesh_area, 1e-9 * q.mesh_area);
  EXPECT_EQ(std::min(left.worst_sj, right.worst_sj), q.sj_all.min);
}

TEST(MeasureQuality, OfNothingIsAllZeroAndStopsOnCancel) {
  MeshResult result;
  QualityReport q = measure(result, 1);
  EXPECT_EQ(q.quads, 0);
  EXPECT_FALSE(q.watertight);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(measure_quality(result.mesh, 1, {}, result.report.faces, progress), Error);
}

}  // namespace
}  // namespace paver
