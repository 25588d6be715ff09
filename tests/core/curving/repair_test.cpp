#include "curving/repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "curving/order2.h"

namespace paver {
namespace {

// Jacobian of a flat quad9 at a grid of points: enough to tell a fold in these tests.
bool is_unfolded(const SurfaceMesh& mesh, bool is_quad, int element) {
  if (!is_quad) return true;
  // Rows of the nine nodes on the grid r, s = -1, 0, 1.
  static constexpr std::array<int, 9> grid = {0, 4, 1, 7, 8, 5, 3, 6, 2};
  auto shape = [](double t) { return std::array<double, 3>{0.5 * t * (t - 1), 1 - t * t, 0.5 * t * (t + 1)}; };
  auto slope = [](double t) { return std::array<double, 3>{t - 0.5, -2 * t, t + 0.5}; };
  for (int i = 0; i <= 10; ++i) {
    for (int j = 0; j <= 10; ++j) {
      double r = -1 + 0.2 * i, s = -1 + 0.2 * j;
      Vec3 xr, xs;
      for (std::size_t k = 0; k < 9; ++k) {
        int node = mesh.quads[9 * static_cast<std::size_t>(element) + static_cast<std::size_t>(grid[k])];
        Vec3 x = mesh.nodes[static_cast<std::size_t>(node)];
        xr += slope(r)[k % 3] * shape(s)[k / 3] * x;
        xs += shape(r)[k % 3] * slope(s)[k / 3] * x;
      }
      if (!(cross(xr, xs).z > 1e-12)) return false;
    }
  }
  return true;
}

// Two unit squares side by side; node 5 the middle of the common side.
SurfaceMesh two_squares() {
  SurfaceMesh mesh;
  mesh.order = 2;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},   {0, 1, 0},   {0.5, 0, 0}, {1, 0.5, 0},   {0.5, 1, 0},  {0, 0.5, 0},
                {2, 0, 0}, {2, 1, 0}, {1.5, 0, 0}, {2, 0.5, 0}, {1.5, 1, 0}, {0.5, 0.5, 0}, {1.5, 0.5, 0}};
  mesh.quads = {0, 1, 2, 3, 4, 5, 6, 7, 13, 1, 8, 9, 2, 10, 11, 12, 5, 14};
  mesh.quad_face = {0, 0};
  mesh.node_edge.assign(mesh.nodes.size(), 0);
  mesh.node_edge[5] = mesh.node_edge[13] = mesh.node_edge[14] = -1;
  mesh.node_target.assign(mesh.nodes.size(), 0);
  return mesh;
}

RepairResult repaired(SurfaceMesh& mesh) {
  std::vector<int> invalid;
  for (int q = 0; q < static_cast<int>(mesh.quad_count()); ++q)
    if (!is_unfolded(mesh, true, q)) invalid.push_back(q);
  return repair_elements(mesh, is_unfolded, invalid, {});
}

TEST(RepairElements, AValidMeshIsNotTouched) {
  SurfaceMesh mesh = two_squares();
  RepairResult result = repaired(mesh);
  EXPECT_EQ(result.straightened, 0);
  EXPECT_TRUE(result.invalid_quads.empty());
}

TEST(RepairElements, AStrayCentreIsBlendedAgain) {
  SurfaceMesh mesh = two_squares();
  mesh.nodes[13] = {0.97, 0.5, 0};
  ASSERT_FALSE(is_unfolded(mesh, true, 0));
  RepairResult result = repaired(mesh);
  EXPECT_EQ(result.straightened, 1);
  EXPECT_TRUE(result.invalid_quads.empty());
  EXPECT_NEAR(norm(mesh.nodes[13] - Vec3{0.5, 0.5, 0}), 0, 1e-15);
}

TEST(RepairElements, AnInnerSideIsStraightenedNoMoreThanNeeded) {
  SurfaceMesh mesh = two_squares();
  mesh.nodes[5] = {-0.2, 0.5, 0};
  ASSERT_FALSE(is_unfolded(mesh, true, 0));
  RepairResult result = repaired(mesh);
  EXPECT_EQ(result.straightened, 1);
  EXPECT_TRUE(is_unfolded(mesh, true, 0));
  EXPECT_TRUE(is_unfolded(mesh, true, 1));
  EXPECT_NEAR(mesh.nodes[5].x, 0.4, 1e-12);
}

TEST(RepairElements, ANeighbourFollowsAndItsOwnNeighbourStaysValid) {
  SurfaceMesh mesh = two_squares();
  int first = static_cast<int>(mesh.nodes.size());
  for (Vec3 x : {Vec3{3, 0, 0}, Vec3{3, 1, 0}, Vec3{2.5, 0, 0}, Vec3{3, 0.5, 0}, Vec3{2.5, 1, 0}, Vec3{2.5, 0.5, 0}})
    mesh.nodes.push_back(x);
  for (int node : {8, first, first + 1, 9, first + 2, first + 3, first + 4, 11, first + 5}) mesh.quads.push_back(node);
  mesh.quad_face.push_back(0);
  mesh.node_edge.resize(mesh.nodes.size(), 0);
  mesh.node_target.resize(mesh.nodes.size(), 0);
  mesh.node_edge[11] = mesh.node_edge.back() = -1;
  mesh.nodes[5] = {-0.2, 0.5, 0};
  mesh.nodes[11] = {0.35, 0.5, 0};  // straightening side 5 alone would cross this one
  for (int quad = 0; quad < 3; ++quad)
    mesh.nodes[static_cast<std::size_t>(mesh.quads[9 * static_cast<std::size_t>(quad) + 8])] =
        blended_centre(mesh, quad);
  ASSERT_FALSE(is_unfolded(mesh, true, 0));
  ASSERT_TRUE(is_unfolded(mesh, true, 1));
  RepairResult result = repaired(mesh);
  EXPECT_TRUE(result.invalid_quads.empty());
  for (int quad = 0; quad < 3; ++quad) EXPECT_TRUE(is_unfolded(mesh, true, quad)) << quad;
}

TEST(RepairElements, SidesOnBRepEdgesStayAndWhatCannotBeMendedIsListed) {
  SurfaceMesh mesh = two_squares();
  mesh.nodes[7] = {1.2, 0.5, 0};
  SurfaceMesh before = mesh;
  RepairResult result = repaired(mesh);
  EXPECT_EQ(result.invalid_quads, (std::vector<int>{0}));
  EXPECT_TRUE(mesh.nodes == before.nodes) << "left as it was";
}

}  // namespace
}  // namespace paver
