// Cut meshes: every element covered once, shared points where shading is smooth, every mesh edge drawn once.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/quality/wavy_mesh.h"
#include "paver/display.h"
#include "paver/quality.h"

namespace paver {
namespace {

Vec3 at(const std::vector<float>& values, int i) {
  std::size_t k = 3 * static_cast<std::size_t>(i);
  return {values[k], values[k + 1], values[k + 2]};
}

std::vector<double> areas(const Tessellation& t, std::size_t elements) {
  std::vector<double> area(elements, 0);
  for (std::size_t i = 0; i < t.triangle_element.size(); ++i) {
    Vec3 a = at(t.points, t.triangles[4 * i]), b = at(t.points, t.triangles[4 * i + 1]),
         c = at(t.points, t.triangles[4 * i + 2]);
    area[static_cast<std::size_t>(t.triangle_element[i])] += 0.5 * norm(cross(b - a, c - a));
  }
  return area;
}

std::size_t edge_count(const SurfaceMesh& mesh) {
  std::set<std::pair<int, int>> edges;
  auto add = [&](const std::vector<int>& elements, int corners, int stride) {
    for (std::size_t e = 0; e + stride <= elements.size(); e += stride)
      for (int k = 0; k < corners; ++k) edges.insert(std::minmax(elements[e + k], elements[e + (k + 1) % corners]));
  };
  add(mesh.quads, 4, mesh.nodes_per_quad());
  add(mesh.triangles, 3, mesh.nodes_per_triangle());
  return edges.size();
}

TEST(Tessellate, ApproachesTheAreaOfEveryElement) {
  SurfaceMesh mesh = fake::WavyMesh(2, 10, 0).result().mesh;
  ElementQuality exact = element_quality(mesh);
  double before = 1;
  for (int n : {1, 4, 16}) {
    Tessellation t = tessellate(mesh, n);
    EXPECT_EQ(t.triangle_element.size(), (2 * mesh.quad_count() + mesh.triangle_count()) * n * n);
    std::vector<double> area = areas(t, exact.area.size());
    double worst = 0;
    for (std::size_t e = 0; e < area.size(); ++e) worst = std::max(worst, std::abs(area[e] / exact.area[e] - 1));
    EXPECT_LT(worst, before / 4);
    before = worst;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(Tessellate, GivesNormalsOfUnitLengthOnTheSideOfTheTriangles) {
  for (int order : {1, 2, 3}) {
    Tessellation t = tessellate(fake::WavyMesh(order, 8, 0.3).result().mesh, 3);
    ASSERT_EQ(t.normals.size(), t.points.size());
    for (std::size_t i = 0; i < t.triangle_element.size(); ++i) {
      const int* p = t.triangles.data() + 4 * i;
      EXPECT_EQ(p[3], -1);
      Vec3 n = cross(at(t.points, p[1]) - at(t.points, p[0]), at(t.points, p[2]) - at(t.points, p[0]));
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(norm(at(t.normals, p[k])), 1, 1e-6);
        EXPECT_GT(dot(at(t.normals, p[k]), unit(n)), 0.7);
      }
    }
  }
}

TEST(Tessellate, SharesPointsWithinAFaceAndNotBetweenFaces) {
  SurfaceMesh mesh = fake::WavyMesh(2, 8, 0).result().mesh;
  const int n = 3;
  Tessellation t = tessellate(mesh, n);
  std::map<int, int> face_of_point;
  std::set<std::array<float, 3>> places;
  for (std::size_t i = 0; i < t.triangle_element.size(); ++i) {
    int e = t.triangle_element[i], quads = static_cast<int>(mesh.quad_count());
    int face = e < quads ? mesh.quad_face[e] : mesh.triangle_face[e - quads];
    for (int k = 0; k < 3; ++k) {
      int p = t.triangles[4 * i + k];
      EXPECT_EQ(face_of_point.try_emplace(p, face).first->second, face);
      places.insert({t.points[3 * p], t.points[3 * p + 1], t.points[3 * p + 2]});
    }
  }
  // Euler's formula counts the places; those of the common edge of the two faces are there twice.
  std::size_t corners = 9 * 9, sides = edge_count(mesh);
  std::size_t inside = mesh.quad_count() * (n - 1) * (n - 1) + mesh.triangle_count() * (n - 1) * (n - 2) / 2;
  std::size_t all = corners + sides * (n - 1) + inside, common = 8 * n + 1;
  EXPECT_EQ(places.size(), all);
  EXPECT_EQ(face_of_point.size(), all + common);
  EXPECT_EQ(t.points.size(), 3 * (all + common));
}

TEST(Tessellate, DrawsEveryMeshEdgeOnceAndKnowsTheEdgesOfTheModel) {
  SurfaceMesh mesh = fake::WavyMesh(2, 8, 0).result().mesh;
  const int n = 4;
  Tessellation t = tessellate(mesh, n);
  ASSERT_EQ(t.outline_edge.size(), edge_count(mesh));
  ASSERT_EQ(t.outlines.size(), t.outline_edge.size() * (n + 2));
  std::map<int, int> lines;
  for (std::size_t i = 0; i < t.outline_edge.size(); ++i) {
    const int* points = t.outlines.data() + i * (n + 2);
    EXPECT_EQ(points[n + 1], -1);
    ++lines[t.outline_edge[i]];
    for (int k = 0; k < n; ++k) {
      double step = norm(at(t.points, points[k + 1]) - at(t.points, points[k]));
      EXPECT_GT(step, 1.5) << "pieces of a side of about 10 mm, or of a diagonal";
      EXPECT_LT(step, 5);
    }
  }
  for (int edge = 0; edge < 5; ++edge) EXPECT_EQ(lines[edge], 8) << edge;
  EXPECT_EQ(lines[-1], static_cast<int>(t.outline_edge.size()) - 40);
}

TEST(Tessellate, PutsPointsOfNeighboursInOneOrder) {
  // Points on a common side are shared: a piece of outline is a side of exactly one or two triangles.
  SurfaceMesh mesh = fake::WavyMesh(2, 6, 0.5).result().mesh;
  const int n = 3;
  Tessellation t = tessellate(mesh, n);
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t i = 0; i < t.triangle_element.size(); ++i)
    for (int k = 0; k < 3; ++k) ++uses[std::minmax(t.triangles[4 * i + k], t.triangles[4 * i + (k + 1) % 3])];
  for (std::size_t i = 0; i < t.outline_edge.size(); ++i) {
    const int* points = t.outlines.data() + i * (n + 2);
    for (int k = 0; k < n; ++k) EXPECT_EQ(uses[std::minmax(points[k], points[k + 1])], t.outline_edge[i] < 0 ? 2 : 1);
  }
}

TEST(Tessellate, GivesNormalsWhereASideShrinksToAPoint) {
  SurfaceMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}};
  mesh.quads = {0, 1, 2, 3};
  mesh.quad_face = {0};
  for (int n : {1, 2}) {
    Tessellation t = tessellate(mesh, n);
    for (int i = 0; i < static_cast<int>(t.points.size() / 3); ++i) EXPECT_NEAR(at(t.normals, i).z, 1, 1e-6);
  }
}

TEST(Tessellate, RefusesOtherSubdivisions) {
  for (int n : {0, -1, most_subdivisions + 1}) EXPECT_THROW(tessellate(SurfaceMesh(), n), Error);
  EXPECT_TRUE(tessellate(SurfaceMesh(), 1).triangles.empty());
}

}  // namespace
}  // namespace paver
