// Rays against all triangles one by one.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/quality/wavy_mesh.h"
#include "paver/display.h"
#include "paver/pick.h"

namespace paver {
namespace {

/// The three determinants say on which side of the line through `origin` along `d` every edge passes.
bool is_met(const Tessellation& t, std::size_t triangle, Vec3 origin, Vec3 d) {
  double sides[3];
  Vec3 corner[3];
  for (int k = 0; k < 3; ++k) {
    const float* x = t.points.data() + 3 * static_cast<std::size_t>(t.triangles[4 * triangle + k]);
    corner[k] = Vec3{x[0], x[1], x[2]} - origin;
  }
  for (int k = 0; k < 3; ++k) sides[k] = dot(d, cross(corner[k], corner[(k + 1) % 3]));
  return (sides[0] > 0 && sides[1] > 0 && sides[2] > 0) || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0);
}

Vec3 centre(const Tessellation& t, std::size_t triangle) {
  Vec3 sum;
  for (int k = 0; k < 3; ++k) {
    const float* x = t.points.data() + 3 * static_cast<std::size_t>(t.triangles[4 * triangle + k]);
    sum += (1.0 / 3) * Vec3{x[0], x[1], x[2]};
  }
  return sum;
}

TEST(PickTree, FindsWhatARayMeets) {
  Tessellation t = tessellate(fake::WavyMesh(2, 12, 0.3).result().mesh, 3);
  PickTree tree(t.points, t.triangles);
  std::mt19937 random(3);
  auto number = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  int met = 0;
  for (int i = 0; i < 300; ++i) {
    Vec3 target = {60 + 70 * number(), 60 + 70 * number(), 0}, origin = {60 + 90 * number(), 60 + 90 * number(), 200};
    std::set<int> wanted, found;
    for (std::size_t k = 0; k < t.triangle_element.size(); ++k)
      if (is_met(t, k, origin, target - origin)) wanted.insert(static_cast<int>(k));
    double before = 0;
    for (const PickHit& hit : tree.hits(origin, target - origin)) {
      EXPECT_GE(hit.along, before);
      before = hit.along;
      found.insert(hit.triangle);
    }
    EXPECT_EQ(found, wanted);
    met += !found.empty();
  }
  EXPECT_GT(met, 150);
}

TEST(PickTree, FindsEveryTriangleAtItsCentreFromBothSides) {
  Tessellation t = tessellate_apart(fake::WavyMesh(1, 7, 0).result().mesh, 2);
  PickTree tree(t.points, t.triangles);
  for (std::size_t k = 0; k < t.triangle_element.size(); ++k) {
    for (double side : {-1.0, 1.0}) {
      Vec3 away = {0.1, 0.2, 100 * side}, c = centre(t, k);
      std::vector<PickHit> hits = tree.hits(c + away, -1.0 * away);
      ASSERT_FALSE(hits.empty());
      EXPECT_EQ(hits.front().triangle, static_cast<int>(k));
      EXPECT_NEAR(hits.front().along, 1, 1e-5);
    }
  }
}

TEST(PickTree, LetsNoRaySlipBetweenTwoTriangles) {
  // Straight down on corners and middles of sides of a flat grid, where rounding decides.
  std::vector<float> points;
  std::vector<int> triangles;
  const int n = 9;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) points.insert(points.end(), {float(i) / n, float(j) / n, 0.1f});
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      int a = j * (n + 1) + i;
      triangles.insert(triangles.end(), {a, a + 1, a + n + 1, -1, a + 1, a + n + 2, a + n + 1, -1});
    }
  }
  PickTree tree(points, triangles);
  for (int j = 0; j <= 2 * n; ++j)
    for (int i = 0; i <= 2 * n; ++i)
      EXPECT_FALSE(tree.hits({double(float(i) / (2 * n)), double(float(j) / (2 * n)), 5}, {0, 0, -1}).empty());
  EXPECT_TRUE(tree.hits({0.5, 0.5, -5}, {0, 0, -1}).empty()) << "behind the origin";
  EXPECT_TRUE(tree.hits({0.5, 0.5, 5}, {0, 0, 0}).empty());
  EXPECT_TRUE(tree.hits({1.5, 0.5, 5}, {0, 0, -1}).empty());
}

TEST(PickTree, OfNothingFindsNothing) { EXPECT_TRUE(PickTree({}, {}).hits({0, 0, 0}, {1, 0, 0}).empty()); }

}  // namespace
}  // namespace paver
