// Small meshes with one fault each; what comes of them must be valid, and nothing else may have changed.
#include "repair/mend_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "curving/near_surface.h"
#include "repair/edits/divide_inside.h"
#include "repair/edits/patch.h"
#include "repair/find_bad.h"
#include "support/dome.h"
#include "support/fake_model.h"
#include "support/planar_region.h"

namespace paver {
namespace {

/// A plane square of 4 by 4 quads, nodes in rows of five; `edges` has no interval.
struct Square {
  Square() : region(test::planar_region({test::divided({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 1)}, 1)) {
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i) {
        const int v = mesh.add_node({1.0 * i, 1.0 * j}, {1.0 * i, 1.0 * j, 0}, {1, 0, 0}, {0, 1, 0}, 1);
        mesh.is_fixed[v] = i % 4 == 0 || j % 4 == 0;
      }
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) mesh.add_element({5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5});
    for (auto& loop : region.loops)
      for (LoopNode& node : loop) node.edge = -1;
  }
  void put(int v, Vec2 p) { mesh.p[v] = p, mesh.x[v] = {p.x, p.y, 0}; }
  std::vector<int> worth_less_than(double value) const {
    const BoundarySides sides(region, edges);
    const ElementJudge judge(region, mesh, sides, 2);
    std::vector<int> found;
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e)
      if (mesh.elements[e].is_alive() && judge.value(e) < value) found.push_back(e);
    return found;
  }
  std::vector<int> bad() const { return worth_less_than(1e-12); }
  Mended mend(const std::vector<int>& which, Elements elements = Elements::quad_dominant) {
    const BoundarySides sides(region, edges);
    return mend_region({region, mesh, sides, 2}, kinds_of(elements), which, mesh);
  }
  Mended mend(Elements elements = Elements::quad_dominant) { return mend(bad(), elements); }
  /// The square over a dome of this height, smaller than it; `offset` of the nodes that are free.
  template <class Offset>
  void lay_on_dome(double height, Offset offset) {
    region = test::dome(height, 12, 0.3);
    region.loops.clear();
    for (int v = 0; v < 25; ++v) {
      Vec2 uv = 0.15 * mesh.p[v] + Vec2{0.2, 0.2};
      if (!mesh.is_fixed[v]) uv = uv + offset();
      mesh.put(v, region.place(region.chart->to_chart(uv)));
      mesh.h[v] = 0.3;
    }
  }

  Region region;
  RegionMesh mesh;
  EdgeNodes edges;
};

TEST(FindBad, FindsAllThatAreNotValidAndNoneThatIsNotPoor) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-0.6, 0.6);
  for (int i = 0; i < 200; ++i) {
    Square square;
    for (int v = 0; v < 25; ++v)
      if (!square.mesh.is_fixed[v]) square.put(v, square.mesh.p[v] + Vec2{off(random), off(random)});
    const BoundarySides sides(square.region, square.edges);
    const std::vector<int> found = find_bad({square.region, square.mesh, sides, 2}),
                           poor_ones = square.worth_less_than(fair);
    EXPECT_TRUE(std::ranges::includes(found, square.bad()));
    EXPECT_TRUE(std::ranges::includes(poor_ones, found));
  }
}

TEST(MendRegion, LeavesAGoodMeshAlone) {
  Square square;
  EXPECT_TRUE(square.bad().empty());
  EXPECT_TRUE(square.mend().places.empty());
}

TEST(MendRegion, MovesANodeThatFoldsElements) {
  Square square;
  square.put(12, {2.75, 2.75});
  ASSERT_FALSE(square.bad().empty());
  const Mended mended = square.mend();
  EXPECT_TRUE(square.bad().empty());
  EXPECT_TRUE(mended.left.empty());
  for (const MendedPlace& place : mended.places) EXPECT_EQ(place.kind, ElementRepairKind::moved);
  EXPECT_EQ(square.mesh.elements.size(), 16U);
  EXPECT_NEAR(test::chart_area(square.mesh), 16, 1e-9);
  for (int v : {0, 4, 20, 24}) EXPECT_EQ(square.mesh.star[v].size(), 1);
}

TEST(MendRegion, FillsAnewWhatNoMoveMends) {
  Square square;
  for (int v = 0; v < 25; ++v) square.mesh.is_fixed[v] = 1;
  square.put(6, {2.3, 1.9});
  square.mesh.is_fixed[6] = 0;
  square.mesh.is_fixed[7] = 1;
  square.put(7, {1.2, 0.6});
  ASSERT_FALSE(square.bad().empty());
  square.mend();
  EXPECT_TRUE(square.bad().empty());
  EXPECT_NEAR(test::chart_area(square.mesh), 16, 1e-9);
}

TEST(MendRegion, FillsManyElementsAnewWhereANodeOfTheLoopLiesAcrossThem) {
  constexpr int count = 16;
  Square square;
  square.mesh = RegionMesh();
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const double reach = i == count / 2 ? -0.8 : 1;  // almost to the other side
    const Vec2 p{reach * std::cos(angle), std::sin(angle)};
    const int v = square.mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 1);
    square.mesh.is_fixed[v] = 1;
  }
  for (int i = 1; i < count / 2; ++i) {  // in zigzag from node 0 to the one that is off
    if (i > 1) square.mesh.add_element({i - 1, i, count - i + 1, -1});
    square.mesh.add_element({i, count - i, (count - i + 1) % count, -1});
  }
  square.mesh.add_element({count / 2 - 1, count / 2, count / 2 + 1, -1});
  ASSERT_FALSE(square.bad().empty());
  square.mend();
  EXPECT_TRUE(square.bad().empty());
}

TEST(MendRegion, MakesNoTrianglesWhereNoneAreWanted) {
  Square square;
  for (int v = 0; v < 25; ++v) square.mesh.is_fixed[v] = 1;
  square.put(12, {3.4, 3.3});
  square.mend(Elements::all_quad);
  for (const Element& e : square.mesh.elements) EXPECT_TRUE(!e.is_alive() || e.corners() == 4);
}

TEST(MendRegion, TellsEveryElementThatStaysBad) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> off(-0.12, 0.12), height(1, 6);
  for (int i = 0; i < 60; ++i) {
    Square square;
    square.lay_on_dome(height(random), [&] { return Vec2{off(random), off(random)}; });
    const Mended mended = square.mend();
    for (int e : square.bad()) EXPECT_TRUE(std::ranges::count(mended.left, e)) << i << " " << e;
  }
}

TEST(MendRegion, BringsElementsThatAreFarOffNearerWithoutTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-0.03, 0.03);
  int before = 0, after = 0;
  for (int i = 0; i < 200; ++i) {
    Square square;
    square.lay_on_dome(1 + 0.025 * i, [&] { return Vec2{off(random), off(random)}; });
    if (!square.bad().empty()) continue;
    const BoundarySides sides(square.region, square.edges);
    const std::vector<int> found = find_bad({square.region, square.mesh, sides, 2}),
                           far = square.worth_less_than(very_poor);
    EXPECT_TRUE(std::ranges::includes(found, far)) << i;
    before += static_cast<int>(far.size());
    square.mend(found);
    after += static_cast<int>(square.worth_less_than(very_poor).size());
    EXPECT_TRUE(square.bad().empty()) << i;
    for (const Element& e : square.mesh.elements) EXPECT_TRUE(!e.is_alive() || e.corners() == 4) << i;
  }
  EXPECT_GT(before, 50);
  EXPECT_LT(after, before / 2);
}

/// A wedge of one quad: its corner in the middle of the upper side is flat, and the curve there bends the other way.
struct Wedge : Square {
  Wedge() {
    const std::vector<Vec2> corners{{0, 0}, {10, 0}, {20, 0.8005}, {10, 0.4005}};
    const std::vector<Vec3> middles{{5, 0, 0}, {15, 0.4, 0}, {15, 0.602, 0}, {5, 0.201, 0}};
    region = test::planar_region({corners}, 4);
    mesh = RegionMesh();
    edges.edges.resize(4);
    for (int i = 0; i < 4; ++i) {
      const Vec2 p = corners[i], q = corners[(i + 1) % 4];
      const int v = mesh.add_node(p, {p.x, p.y, 0}, {1, 0, 0}, {0, 1, 0}, 4);
      mesh.is_fixed[v] = 1, mesh.global[v] = i;
      region.loops[0][i].edge = i, region.loops[0][i].global = i;
      edges.edges[i] = {{0, 0.5, 1}, {{p.x, p.y, 0}, middles[i], {q.x, q.y, 0}}, {i, (i + 1) % 4}};
    }
    mesh.add_element({0, 1, 2, 3});
  }
};

TEST(MendRegion, MakesTrianglesWhereAQuadWouldHaveToLeaveItsEdges) {
  Wedge wedge;
  const BoundarySides sides(wedge.region, wedge.edges);
  EXPECT_EQ((ElementJudge{wedge.region, wedge.mesh, sides, 2}.value(0)), value_of_cusp);
  wedge.mend({0});
  EXPECT_EQ(wedge.mesh.triangle_count(), 2);
  EXPECT_TRUE(wedge.worth_less_than(2 * value_of_cusp).empty());
}

TEST(MendRegion, IsTheSameEveryTime) {
  Square one, two;
  one.put(12, {3.4, 3.3}), two.put(12, {3.4, 3.3});
  one.mend(), two.mend();
  EXPECT_EQ(one.mesh.p, two.mesh.p);
  ASSERT_EQ(one.mesh.elements.size(), two.mesh.elements.size());
  for (std::size_t e = 0; e < one.mesh.elements.size(); ++e) EXPECT_EQ(one.mesh.elements[e].v, two.mesh.elements[e].v);
}

TEST(DivideIntervals, MakesTheMiddleANode) {
  fake::Line line({0, 0, 0}, {4, 0, 0});
  Model model;
  model.edges.emplace_back();
  model.edges[0].curve = std::make_shared<fake::Line>(line);
  EdgeNodes nodes;
  nodes.nodes = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}};
  nodes.node_edge = {0, 0, 0};
  nodes.node_target = {2, 2, 4};
  nodes.edges.push_back({{0, 0.25, 0.5, 0.75, 1}, {}, {0, 1, 2}});
  for (double t : nodes.edges[0].t) nodes.edges[0].x.push_back(line.point(t));
  const auto divided = divide_intervals(model, {{0, 2, 1}, {0, 1, 2}}, nodes);
  ASSERT_EQ(divided.size(), 1U);
  EXPECT_EQ(divided[0].node, 3);
  EXPECT_EQ(nodes.edges[0].node, (std::vector<int>{0, 1, 3, 2}));
  EXPECT_EQ(nodes.edges[0].intervals(), 3);
  EXPECT_EQ(nodes.nodes[3], (Vec3{3, 0, 0}));
  EXPECT_DOUBLE_EQ(nodes.node_target[3], 3);
  for (std::size_t i = 0; i < nodes.edges[0].t.size(); ++i) {
    EXPECT_EQ(nodes.edges[0].x[i], line.point(nodes.edges[0].t[i]));
    if (i > 0) {
      EXPECT_LT(nodes.edges[0].t[i - 1], nodes.edges[0].t[i]);
    }
  }
  EXPECT_NEAR(nodes.edges[0].x[3].x, 2.5, 1e-9);
}

TEST(DivideBoundarySides, GivesTheElementThereTheNode) {
  Square square;
  for (int i = 0; i < 5; ++i) square.mesh.global[i] = i;
  square.edges.nodes.assign(6, {});
  square.edges.nodes[5] = {1.5, 0, 0};
  const BoundarySides sides(square.region, square.edges);
  divide_boundary_sides({square.region, square.mesh, sides, 2}, square.edges, {{2, 1, 5}}, {}, square.mesh);
  ASSERT_EQ(square.mesh.node_count(), 26);
  EXPECT_EQ(square.mesh.global[25], 5);
  EXPECT_TRUE(square.mesh.is_fixed[25]);
  EXPECT_EQ(square.mesh.across(2, 1), -1);
  EXPECT_NEAR(test::chart_area(square.mesh), 16, 1e-9);
  EXPECT_TRUE(square.bad().empty());
}

}  // namespace
}  // namespace paver
