// Edits of the front on small squares: facets, void and mesh must agree after each.
#include "paving/front/front.h"

#include <gtest/gtest.h>

#include <cmath>

#include "charts/chart.h"
#include "paving/front/facing.h"
#include "support/fake_model.h"
#include "support/planar_region.h"
#include "support/validate.h"

namespace paver {
namespace {

using test::divided;
using test::front_faults;
using test::reversed;

/// Front over a region; node numbers are those of the loops' points, one loop after another, facet i starts at node i.
struct Fixture {
  explicit Fixture(const std::vector<std::vector<Vec2>>& loops)
      : region(test::planar_region(loops, 1)), front(region, mesh) {
    EXPECT_FALSE(front.start());
    EXPECT_EQ(front_faults(front), "");
  }
  int node_at(Vec2 p) const {
    for (int i = 0; i < mesh.node_count(); ++i)
      if (norm(mesh.p[i] - p) < 1e-9) return i;
    return -1;
  }
  /// The live facet that starts at p.
  int facet_at(Vec2 p) const { return front.facet_from(node_at(p)); }
  /// A new node in the void, seen from the start of facet f.
  int put(Vec2 p, int f) {
    int node = front.add_node(p);
    Location where = front.empty.walk(front.empty.facet_side(f).triangle, front.facets[f].a, p);
    EXPECT_TRUE(front.empty.insert(node, where));
    return node;
  }
  int loop_size(int f) const {
    std::vector<int> loop;
    front.collect_loop(f, loop);
    return static_cast<int>(loop.size());
  }
  int live_facets() const {
    int count = 0;
    for (const Facet& f : front.facets) count += f.is_alive;
    return count;
  }

  Region region;
  RegionMesh mesh;
  Front front;
};

std::vector<Vec2> rectangle(double width, double height, Vec2 at = {0, 0}) {
  return divided({at, at + Vec2{width, 0}, at + Vec2{width, height}, at + Vec2{0, height}}, 1);
}

TEST(Front, StartsWithTheRegionsLoops) {
  Fixture t({rectangle(4, 4), reversed(rectangle(1, 1, {1, 2}))});
  EXPECT_EQ(t.loop_size(0), 16);
  EXPECT_EQ(t.loop_size(16), 4);
  EXPECT_EQ(t.live_facets(), 20);
  EXPECT_NEAR(t.front.angle_after(0), M_PI, 1e-12);
  EXPECT_NEAR(t.front.angle_after(15), M_PI / 2, 1e-12);
  EXPECT_NEAR(t.front.angle_after(16), 1.5 * M_PI, 1e-12);
}

TEST(Front, ReportsLoopsThatCross) {
  Region region = test::planar_region({rectangle(4, 4), reversed(rectangle(2, 1, {3, 1}))}, 1);
  RegionMesh mesh;
  Front front(region, mesh);
  EXPECT_TRUE(front.start());
}

TEST(Front, AnElementInACornerTakesTwoFacetsAndGivesTwo) {
  Fixture t({rectangle(4, 4)});
  int inner = t.put({1, 1}, 0);
  ASSERT_TRUE(t.front.form_element(0, inner, 15, 1));
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.mesh.elements.size(), 1u);
  EXPECT_EQ(t.loop_size(1), 16);
  EXPECT_EQ(t.front.sectors(0), 0);
  EXPECT_EQ(t.front.facet_from(0), -1);
  EXPECT_NEAR(t.front.angle_after(t.facet_at({0, 1})), 1.5 * M_PI, 1e-12);
  EXPECT_EQ(t.front.facets[t.facet_at({1, 1})].level, 1);
}

TEST(Front, AnElementAcrossSplitsTheLoop) {
  Fixture t({rectangle(6, 3)});
  int f = t.facet_at({2, 0});
  ASSERT_TRUE(t.front.form_element(f, t.node_at({3, 3}), t.node_at({2, 3}), 1));
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.loop_size(t.facet_at({0, 0})), 8);   // 2 x 3 less nothing: 2 + 3 + 2 + 1
  EXPECT_EQ(t.loop_size(t.facet_at({5, 0})), 10);  // 3 + 3 + 3 + 1
  EXPECT_FALSE(t.front.is_alone(t.facet_at({0, 0}), 7));
  EXPECT_TRUE(t.front.is_alone(t.facet_at({0, 0}), 8));
}

TEST(Front, AnElementBetweenTwoLoopsJoinsThem) {
  Fixture t({rectangle(6, 6), reversed(rectangle(2, 2, {2, 2}))});
  t.front.colour_loop(0);
  t.front.colour_loop(24);
  int f = t.facet_at({2, 0});
  EXPECT_FALSE(t.front.is_alone(f, 24));
  ASSERT_TRUE(t.front.form_element(f, t.node_at({3, 2}), t.node_at({2, 2}), 1));
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.loop_size(t.facet_at({0, 0})), 24 + 8);
  EXPECT_TRUE(t.front.is_alone(t.facet_at({0, 0}), 32));
}

TEST(Front, ANodeMayStandInSeveralSectors) {
  Fixture t({rectangle(6, 6)});
  // A quad that touches the far side in one corner only: (3,0) (4,0) ... its far corners are one front node and a new
  // one.
  int top = t.node_at({3, 6}), f = t.facet_at({2, 0}), fresh = t.put({4, 3}, f);
  ASSERT_TRUE(t.front.form_element(f, fresh, top, 1));
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.front.sectors(top), 2);
  EXPECT_EQ(t.live_facets(), 26);
}

TEST(Front, ColoursForbidWhatWouldLeaveOddLoops) {
  Fixture t({rectangle(6, 2)});
  int f = t.facet_at({2, 0}), c = t.node_at({3, 2}), d = t.node_at({2, 2});
  t.front.colour_loop(0);
  EXPECT_FALSE(t.front.may_connect(t.node_at({2, 0}), d));
  EXPECT_TRUE(t.front.may_connect(t.node_at({2, 0}), t.node_at({3, 2})));
  EXPECT_FALSE(t.front.form_element(f, c, d, 1));
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.live_facets(), 16);
  EXPECT_TRUE(t.mesh.elements.empty());
  Fixture free({rectangle(6, 2)});  // without colours nothing speaks against it
  EXPECT_TRUE(free.front.form_element(f, c, d, 1));
  EXPECT_EQ(front_faults(free.front), "");
}

TEST(Front, JoinedLoopsShareTheirColours) {
  Fixture t({rectangle(6, 6), reversed(rectangle(2, 2, {2, 2}))});
  t.front.colour_loop(0);
  t.front.colour_loop(24);
  int far = t.node_at({3, 6});
  EXPECT_TRUE(t.front.may_connect(t.node_at({3, 4}), far));  // different loops: anything goes
  EXPECT_TRUE(t.front.may_connect(t.node_at({2, 4}), far));
  ASSERT_TRUE(t.front.form_element(t.facet_at({2, 0}), t.node_at({3, 2}), t.node_at({2, 2}), 1));
  // Across the gap of two: from (2, 0) up 1, along the hole 2 x 1 ... an even and an odd way.
  EXPECT_NE(t.front.may_connect(t.node_at({3, 4}), far), t.front.may_connect(t.node_at({2, 4}), far));
}

TEST(Front, RefusesElementsThatOverlapTheFront) {
  Fixture t({rectangle(6, 6), reversed(rectangle(2, 2, {2, 2}))});
  int f = t.facet_at({2, 0});
  EXPECT_FALSE(t.front.form_element(f, t.node_at({4, 6}), t.node_at({3, 6}), 1));  // the hole is in the way
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_FALSE(t.front.form_element(f, t.front.facets[f].a, t.node_at({2, 2}), 1));  // a corner twice
  int between = t.put({2.5, 1}, f);
  EXPECT_FALSE(t.front.form_element(f, t.node_at({3, 2}), t.node_at({2, 2}), 1));  // a node lies inside
  EXPECT_EQ(t.front.sectors(between), 0);
  EXPECT_EQ(t.live_facets(), 32);
}

TEST(Front, SeamsJoinTwoFacets) {
  Fixture t({{{0, 0}, {1.9, 0}, {2, -1.5}, {2.1, 0}, {4, 0}, {4, 4}, {0, 4}}});
  t.mesh.is_fixed[1] = t.mesh.is_fixed[3] = 0;
  EXPECT_FALSE(t.front.close_seam(1, {2, 5}));  // there the void would be turned over
  EXPECT_EQ(front_faults(t.front), "");
  ASSERT_TRUE(t.front.close_seam(1, {2, 0}));
  EXPECT_EQ(t.live_facets(), 5);
  EXPECT_EQ(t.loop_size(0), 5);
  t.region.loops[0].erase(t.region.loops[0].begin() + 2, t.region.loops[0].begin() + 4);
  t.region.loops[0][1].p = {2, 0};
  EXPECT_EQ(front_faults(t.front), "");
}

TEST(Front, DividesAFacetInThreeWithItsQuad) {
  Fixture t({rectangle(4, 4)});
  t.front.colour_loop(0);
  EXPECT_EQ(t.front.divide_facet(0), -1);  // boundary
  int inner = t.put({1, 1}, 0);
  ASSERT_TRUE(t.front.form_element(0, inner, 15, 1));
  int f = t.front.divide_facet(t.facet_at({1, 1}));
  ASSERT_GE(f, 0);
  EXPECT_EQ(front_faults(t.front), "");
  EXPECT_EQ(t.loop_size(f), 18);
  int elements = 0;
  for (const Element& e : t.mesh.elements) elements += e.is_alive();
  EXPECT_EQ(elements, 4);
}

TEST(Front, NodesMoveOnlyWhereNothingTurnsOver) {
  Fixture t({rectangle(4, 4)});
  int inner = t.put({1, 1}, 0);
  ASSERT_TRUE(t.front.form_element(0, inner, 15, 1));
  EXPECT_TRUE(t.front.can_move(inner, {1.2, 0.8}));
  EXPECT_FALSE(t.front.can_move(inner, {0.4, 0.4}));  // concave
  EXPECT_FALSE(t.front.can_move(inner, {5, 5}));
  t.mesh.put(inner, t.region.place({1.2, 1.3}));
  t.front.renew_void({inner});
  EXPECT_EQ(front_faults(t.front), "");
}

TEST(Front, SlidesStayNearTheSurfaceAndEndOnIt) {
  constexpr double radius = 3;
  Region region = test::planar_region({rectangle(4, 4)}, 1);
  region.surface = std::make_shared<fake::Cylinder>(radius);
  RegionMesh mesh;
  Front front(region, mesh);
  auto off = [&] { return std::fabs(std::hypot(mesh.x[0].x, mesh.x[0].y) - radius); };
  for (Vec2 p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) front.add_node(p);
  mesh.add_element({0, 1, 2, -1});
  mesh.h[0] = 1;
  for (int i = 1; i <= 20; ++i) {
    front.slide(0, {0.01 * i, 0.3});  // a fifth of the target length is 0.067
    EXPECT_LT(off(), 0.01);
    if (i == 5) {
      EXPECT_GT(off(), 1e-6);
    }
  }
  front.end_slides();
  EXPECT_LT(off(), 1e-12);
  EXPECT_EQ(mesh.p[0], (Vec2{0.2, 0.3}));
}

// Round a cylinder the chart is polar: between a chord of the upper rim and the rim lies what is above the cylinder.
TEST(Front, TellsWhatLiesBeyondAFacetInAChartThatBendsLines) {
  constexpr int facets = 6;
  Region region;
  region.surface = std::make_shared<fake::Cylinder>(2);
  region.chart = make_polar_chart(*region.surface, {{0, 0}, {2 * fake::pi, 5}}, 2 * fake::pi);
  region.goes_round = true;
  for (double height : {0.0, 5.0}) {
    std::vector<LoopNode>& loop = region.loops.emplace_back();
    for (int i = 0; i < facets; ++i) {
      const Vec2 uv{2 * fake::pi / facets * (height > 0 ? -i : i), height};
      loop.push_back({static_cast<int>(region.loops.size()) * facets + i - facets, 0, region.chart->to_chart(uv),
                      region.surface->point(uv), 2});
    }
  }
  RegionMesh mesh;
  Front front(region, mesh);
  ASSERT_FALSE(front.start());
  auto is_beyond = [&](double height) {
    const Vec2 p = region.chart->to_chart({-fake::pi / facets, height});
    const Location where = front.empty.walk(front.empty.facet_side(facets).triangle, facets, p);
    EXPECT_NE(where.kind, Location::Kind::blocked);
    return is_beyond_facet(front, where.triangle, region.place(p));
  };
  EXPECT_TRUE(is_beyond(5.1));
  EXPECT_FALSE(is_beyond(4.9));
}

TEST(Front, GivesAwayTheVoidOfOneLoop) {
  Fixture t({rectangle(6, 3)});
  ASSERT_TRUE(t.front.form_element(t.facet_at({2, 0}), t.node_at({3, 3}), t.node_at({2, 3}), 1));
  auto triangles = t.front.take_void(t.facet_at({0, 0}));
  EXPECT_EQ(triangles.size(), 6u);
  EXPECT_EQ(t.live_facets(), 10);
  EXPECT_EQ(t.front.facet_from(t.node_at({0, 1})), -1);
  EXPECT_GE(t.front.newest_facet(), 0);
}

}  // namespace
}  // namespace paver
