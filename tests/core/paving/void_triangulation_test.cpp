#include "paving/front/void_triangulation.h"

#include <gtest/gtest.h>

#include <random>

#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::circle;
using test::delaunay_faults;
using test::reversed;
using test::void_faults;

/// Loops of points and the void between them.
struct Case {
  std::vector<Vec2> points;
  std::vector<std::pair<int, int>> facets;
  double area = 0;
  VoidTriangulation empty{points};

  void add(const std::vector<Vec2>& loop) {
    int base = static_cast<int>(points.size()), n = static_cast<int>(loop.size());
    points.insert(points.end(), loop.begin(), loop.end());
    for (int i = 0; i < n; ++i) facets.push_back({base + i, base + (i + 1) % n});
    area += test::chart_area(test::planar_region({loop}, 1));
  }
  std::string faults() const { return void_faults(empty, points, facets, area) + delaunay_faults(empty, points); }
  std::string void_only() const { return void_faults(empty, points, facets, area); }
  int triangle_at(int node) const {
    for (int t = 0; t < empty.triangle_count(); ++t)
      if (empty.triangle(t).is_alive && empty.has_node(t, node)) return t;
    return -1;
  }
  int live_triangles() const {
    int count = 0;
    for (int t = 0; t < empty.triangle_count(); ++t) count += empty.triangle(t).is_alive;
    return count;
  }
  bool has_side(int a, int b) const {
    for (int t = 0; t < empty.triangle_count(); ++t)
      if (empty.triangle(t).is_alive && empty.side_between(t, a, b) >= 0) return true;
    return false;
  }
};

const std::vector<Vec2> square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

TEST(VoidTriangulation, FillsALoop) {
  Case c;
  c.add(square);
  ASSERT_FALSE(c.empty.build(c.facets));
  EXPECT_EQ(c.faults(), "");
  EXPECT_EQ(c.live_triangles(), 2);
}

TEST(VoidTriangulation, LeavesHolesOut) {
  Case c;
  c.add(test::divided(square, 0.25));
  c.add(reversed(circle({1, 1}, 0.5, 12)));
  c.add(reversed(circle({3, 2.9}, 0.7, 3)));
  c.add(reversed(circle({1, 3}, 0.02, 40)));
  ASSERT_FALSE(c.empty.build(c.facets));
  EXPECT_EQ(c.faults(), "");
  // Euler: triangles = nodes - 2 + 2 holes.
  EXPECT_EQ(c.live_triangles(), static_cast<int>(c.points.size()) - 2 + 2 * 3);
}

TEST(VoidTriangulation, FillsLoopsOfManyPointsInLine) {
  Case c;
  c.add(test::divided({{0, 0}, {100, 0}, {100, 1e-3}, {0, 1e-3}}, 1));
  ASSERT_FALSE(c.empty.build(c.facets));
  EXPECT_EQ(c.faults(), "");
}

TEST(VoidTriangulation, FillsRandomStars) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  for (int round = 0; round < 50; ++round) {
    Case c;
    std::vector<Vec2> star;
    int n = 3 + static_cast<int>(random() % 200);
    for (int i = 0; i < n; ++i) {
      double a = 2 * 3.141592653589793 * (i + 0.9 * share(random)) / n, r = 0.05 + share(random);
      star.push_back({1e3 + r * std::cos(a), -1e3 + r * std::sin(a)});
    }
    c.add(star);
    auto crossing = c.empty.build(c.facets);
    if (n < 7 && crossing) continue;  // with gaps of more than half a turn the star may cross itself
    ASSERT_FALSE(crossing) << round;
    ASSERT_EQ(c.faults(), "") << round;
  }
}

TEST(VoidTriangulation, NamesFacetsThatCrossOrTouch) {
  Case bow;
  bow.add({{0, 0}, {2, 0.1}, {0, 1}, {2, 1.1}});
  auto crossing = bow.empty.build(bow.facets);
  ASSERT_TRUE(crossing);
  EXPECT_TRUE(*crossing == 1 || *crossing == 3) << *crossing;

  Case outside;  // the hole reaches through side 1
  outside.add(square);
  outside.add(reversed({{3, 1}, {5, 1}, {5, 2}, {3, 2}}));
  EXPECT_TRUE(outside.empty.build(outside.facets));

  Case touching;  // a hole's corner lies on a side
  touching.add(square);
  touching.add(reversed({{2, 0}, {3, 1}, {1, 1}}));
  EXPECT_TRUE(touching.empty.build(touching.facets));

  Case twice;  // a node in the place of another
  twice.add(square);
  twice.add(reversed({{0, 0}, {3, 1}, {1, 2}}));
  EXPECT_TRUE(twice.empty.build(twice.facets));
}

TEST(VoidTriangulation, TakesInsertionsAndErasesThemAgain) {
  Case c;
  c.add(test::divided(square, 1));
  c.add(reversed(circle({2, 2}, 0.8, 7)));
  std::vector<Vec2> wanted{{0.5, 0.5}, {3.5, 0.51}, {0.4, 2}, {3, 3.2}, {0.500001, 0.5}, {2, 0.7}, {0.25, 0.25}};
  std::size_t first = c.points.size();
  c.points.insert(c.points.end(), wanted.begin(), wanted.end());
  ASSERT_FALSE(c.empty.build(c.facets));
  int before = c.live_triangles();
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Location where;  // seen from some node; not all see it
    for (int node = 0; node < static_cast<int>(first + i); ++node) {
      where = c.empty.walk(c.triangle_at(node), node, wanted[i]);
      if (where.kind == Location::Kind::inside || where.kind == Location::Kind::on_side) break;
    }
    ASSERT_TRUE(c.empty.insert(static_cast<int>(first + i), where)) << i;
    ASSERT_EQ(c.faults(), "") << i;
    EXPECT_EQ(c.live_triangles(), before + 2 * static_cast<int>(i + 1));
  }
  for (std::size_t i : {std::size_t{3}, std::size_t{0}, std::size_t{6}, std::size_t{1}, std::size_t{5}, std::size_t{2},
                        std::size_t{4}}) {
    const int node = static_cast<int>(first + i);
    c.empty.erase(node, c.triangle_at(node), node);
    ASSERT_EQ(c.faults(), "") << i;
  }
  EXPECT_EQ(c.live_triangles(), before);
}

TEST(VoidTriangulation, ErasesANodeInLineWithAllItsNeighbours) {
  Case c;
  c.add(square);
  c.points.push_back({2, 2});
  ASSERT_FALSE(c.empty.build(c.facets));
  ASSERT_TRUE(c.empty.insert(4, c.empty.walk(c.triangle_at(0), 0, {2, 2})));
  ASSERT_EQ(c.live_triangles(), 4);
  c.empty.erase(4, c.triangle_at(0), 0);
  EXPECT_EQ(c.faults(), "");
  EXPECT_EQ(c.live_triangles(), 2);
}

TEST(VoidTriangulation, ErasesANodeThatItsOriginDoesNotSee) {
  Case c;
  c.add(square);
  c.add(reversed(circle({2, 2}, 0.2, 4)));
  c.points.push_back({3, 3});
  ASSERT_FALSE(c.empty.build(c.facets));
  ASSERT_TRUE(c.empty.insert(8, c.empty.walk(c.triangle_at(2), 2, {3, 3})));
  c.empty.erase(8, c.triangle_at(0), 0);
  EXPECT_EQ(c.faults(), "");
}

TEST(VoidTriangulation, WalksStopAtFacetsAndFindVertices) {
  Case c;
  c.add(square);
  c.add(reversed(circle({2, 2}, 1, 4)));
  ASSERT_FALSE(c.empty.build(c.facets));
  Location seen = c.empty.walk(c.triangle_at(0), 0, {4, 4});  // the hole is between
  ASSERT_EQ(seen.kind, Location::Kind::blocked);
  EXPECT_GE(facet_of(c.empty.triangle(seen.triangle).n[seen.corner]), 4);
  Location beyond = c.empty.walk(c.triangle_at(0), 0, {9, 1});
  ASSERT_EQ(beyond.kind, Location::Kind::blocked);
  EXPECT_EQ(facet_of(c.empty.triangle(beyond.triangle).n[beyond.corner]), 1);
  Location corner = c.empty.walk(c.triangle_at(0), 0, {4, 0});
  ASSERT_EQ(corner.kind, Location::Kind::on_vertex);
  EXPECT_EQ(c.empty.triangle(corner.triangle).v[corner.corner], 1);
  Location nothing = c.empty.walk(c.triangle_at(0), 0, {-1, -1});
  EXPECT_EQ(nothing.kind, Location::Kind::blocked);
  EXPECT_EQ(nothing.triangle, -1);
}

TEST(VoidTriangulation, DoesNotInsertOnAFacet) {
  Case c;
  c.add(square);
  c.points.push_back({2, 0});
  ASSERT_FALSE(c.empty.build(c.facets));
  Location where = c.empty.walk(c.triangle_at(0), 0, {2, 0});
  EXPECT_EQ(where.kind, Location::Kind::on_side);
  EXPECT_FALSE(c.empty.insert(4, where));
  EXPECT_EQ(c.faults(), "");
}

// A triangle of the fan at a that sees b, by trying all.
bool recover(Case& c, int a, int b) {
  for (int t = 0; t < c.empty.triangle_count(); ++t)
    if (c.empty.triangle(t).is_alive && c.empty.has_node(t, a) && c.empty.recover(t, a, b)) return true;
  return false;
}

TEST(VoidTriangulation, RecoversSidesAndKeepsTheVoidWhole) {
  Case c;
  c.add(test::divided(square, 0.25));
  ASSERT_FALSE(c.empty.build(c.facets));
  std::mt19937 random(6);
  int n = static_cast<int>(c.points.size()), recovered = 0;
  for (int round = 0; round < 300; ++round) {
    int a = static_cast<int>(random() % static_cast<unsigned>(n)),
        b = static_cast<int>(random() % static_cast<unsigned>(n));
    Vec2 d = c.points[static_cast<std::size_t>(b)] - c.points[static_cast<std::size_t>(a)];
    bool is_along_side = d.x == 0 || d.y == 0;  // nodes in line between, or the outline itself
    if (a == b || is_along_side) continue;
    bool is_made = recover(c, a, b);
    EXPECT_EQ(is_made, c.has_side(a, b));
    recovered += is_made;
    ASSERT_EQ(c.void_only(), "") << a << " " << b;
  }
  EXPECT_GT(recovered, 200);
  std::vector<int> all;
  for (int t = 0; t < c.empty.triangle_count(); ++t) all.push_back(t);
  c.empty.legalise(all);
  EXPECT_EQ(c.faults(), "");
}

TEST(VoidTriangulation, RefusesToCrossAFacetOrANode) {
  Case c;
  c.add(square);
  c.add({{1.5, 1.5}, {1.5, 2.5}, {2.5, 2.5}, {2.5, 1.5}});
  c.points.push_back({0.5, 0.5});
  ASSERT_FALSE(c.empty.build(c.facets));
  EXPECT_FALSE(recover(c, 0, 2));  // through the hole
  EXPECT_FALSE(recover(c, 1, 3));
  EXPECT_EQ(c.void_only(), "");
  int inner = static_cast<int>(c.points.size()) - 1;
  ASSERT_TRUE(c.empty.insert(inner, c.empty.walk(c.triangle_at(0), 0, c.points.back())));
  EXPECT_FALSE(recover(c, 0, 4));  // behind the new node
  EXPECT_EQ(c.faults(), "");
}

TEST(VoidTriangulation, DividesAFacet) {
  Case c;
  c.add(square);
  c.points.push_back({1, 0});
  c.points.push_back({3, 0});
  ASSERT_FALSE(c.empty.build(c.facets));
  c.empty.divide_side(c.empty.facet_side(0), {4, 5}, {4, 5, 6});
  c.facets[0] = {-1, -1};
  c.facets.insert(c.facets.end(), {{0, 4}, {4, 5}, {5, 1}});
  EXPECT_EQ(c.faults(), "");
}

}  // namespace
}  // namespace paver
