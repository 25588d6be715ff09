// Tessellations whose elements share no points.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/quality/wavy_mesh.h"
#include "paver/display.h"

namespace paver {
namespace {

Vec3 at(const std::vector<float>& values, int i) {
  std::size_t k = 3 * static_cast<std::size_t>(i);
  return {values[k], values[k + 1], values[k + 2]};
}

/// Corners of every triangle of an element, and normals there.
using Pieces = std::map<int, std::vector<std::array<double, 18>>>;

Pieces pieces(const Tessellation& t) {
  Pieces found;
  for (std::size_t i = 0; i < t.triangle_element.size(); ++i) {
    std::array<double, 18> piece;
    for (int k = 0; k < 3; ++k) {
      Vec3 x = at(t.points, t.triangles[4 * i + k]), n = at(t.normals, t.triangles[4 * i + k]);
      std::copy_n(std::array{x.x, x.y, x.z, n.x, n.y, n.z}.begin(), 6, piece.begin() + 6 * k);
    }
    found[t.triangle_element[i]].push_back(piece);
  }
  return found;
}

TEST(TessellateApart, DrawsWhatTheSharedOneDraws) {
  SurfaceMesh mesh = fake::WavyMesh(2, 10, 0.2).result().mesh;
  for (int n : {1, 2, 3}) {
    Tessellation shared = tessellate(mesh, n), apart = tessellate_apart(mesh, n);
    EXPECT_EQ(pieces(apart), pieces(shared));
    EXPECT_EQ(apart.outline_edge, shared.outline_edge);
    EXPECT_EQ(apart.outline_elements, shared.outline_elements);
    ASSERT_EQ(apart.outlines.size(), shared.outlines.size());
    for (std::size_t i = 0; i < apart.outlines.size(); ++i) {
      if (shared.outlines[i] < 0)
        EXPECT_EQ(apart.outlines[i], -1);
      else
        EXPECT_EQ(at(apart.points, apart.outlines[i]), at(shared.points, shared.outlines[i]));
    }
  }
}

TEST(TessellateApart, GivesEveryElementPointsOfItsOwnInOrder) {
  SurfaceMesh mesh = fake::WavyMesh(2, 10, 0).result().mesh;
  const int n = 2;
  Tessellation t = tessellate_apart(mesh, n);
  EXPECT_TRUE(std::is_sorted(t.triangle_element.begin(), t.triangle_element.end()));
  int quads = static_cast<int>(mesh.quad_count()), triangles = static_cast<int>(mesh.triangle_count());
  ASSERT_EQ(static_cast<int>(t.points.size()), 3 * (9 * quads + 6 * triangles));
  for (std::size_t i = 0; i < t.triangle_element.size(); ++i) {
    int e = t.triangle_element[i], first = e < quads ? 9 * e : 9 * quads + 6 * (e - quads);
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(t.triangles[4 * i + k], first);
      EXPECT_LT(t.triangles[4 * i + k], first + (e < quads ? 9 : 6));
    }
  }
}

TEST(Tessellate, CountsTheElementsOfEveryMeshEdge) {
  const int n = 8;
  Tessellation t = tessellate(fake::WavyMesh(2, n, 0).result().mesh, 1);
  for (std::size_t i = 0; i < t.outline_edge.size(); ++i) {
    bool is_at_the_border = t.outline_edge[i] >= 0 && t.outline_edge[i] < 4;
    EXPECT_EQ(t.outline_elements[i], is_at_the_border ? 1 : 2) << i;
  }
}

}  // namespace
}  // namespace paver
