#include "boundary/region_loops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "support/fake_model.h"

namespace paver {
namespace {

std::vector<std::vector<int>> edges_of(const std::vector<Loop>& loops) {
  std::vector<std::vector<int>> edges;
  for (const Loop& loop : loops) {
    edges.emplace_back();
    for (const Coedge& coedge : loop.coedges) edges.back().push_back(coedge.edge);
  }
  return edges;
}

using Edges = std::vector<std::vector<int>>;

TEST(LinkedLoops, ATubeHasTwoCirclesWithoutItsPeriodicEdge) {
  Model tube = fake::tube(1, 2);
  EXPECT_EQ(edges_of(linked_loops(tube, 0)), (Edges{{0}, {2}}));
}

TEST(LinkedLoops, AWholeSphereHasNone) { EXPECT_TRUE(linked_loops(fake::ball(1), 0).empty()); }

TEST(LinkedLoops, AnOrdinaryFaceKeepsItsLoop) {
  Model box = fake::box(1, 1, 1);
  EXPECT_EQ(edges_of(linked_loops(box, 0)), (Edges{{3, 2, 1, 0}}));
}

// Tube whose wall has a hole across the periodic edge: that edge is in two pieces and the hole in two arcs, all in one
// outer loop of the face.
TEST(LinkedLoops, AHoleCutByThePeriodicEdgeBecomesOneLoop) {
  fake::Builder builder;
  const double full = 2 * fake::pi;
  int low = builder.vertex({1, 0, 0}), below = builder.vertex({1, 0, 1});
  int above = builder.vertex({1, 0, 2}), high = builder.vertex({1, 0, 3});
  int bottom = builder.arc({}, 1, 0, full, low, low);
  int first = builder.line(low, below);
  int left = builder.line(below, above), right = builder.line(below, above);  // stand for the two arcs of the hole
  int second = builder.line(above, high);
  int top = builder.arc({0, 0, 3}, 1, 0, full, high, high);
  builder.face(std::make_shared<fake::Cylinder>(1), 1,
               {{builder.use(bottom, false, {0, 0}, {full, 0}), builder.use(first, false, {full, 0}, {full, 1}),
                 builder.use(left, false, {full, 1}, {full, 2}), builder.use(second, false, {full, 2}, {full, 3}),
                 builder.use(top, true, {0, 3}, {full, 3}), builder.use(second, true, {0, 2}, {0, 3}),
                 builder.use(right, true, {0, 1}, {0, 2}), builder.use(first, true, {0, 0}, {0, 1})}});
  Model model = builder.take();
  EXPECT_EQ(edges_of(linked_loops(model, 0)), (Edges{{bottom}, {left, right}, {top}}));
}

// As a torus has whose other periodic edge is cut by a hole: two rings of two edges each, all through one vertex.
TEST(LinkedLoops, RingsThroughOneVertexStayApart) {
  fake::Builder builder;
  const double full = 2 * fake::pi;
  int here = builder.vertex({1, 0, 0}), there = builder.vertex({-1, 0, 0}), beyond = builder.vertex({-1, 0, 1});
  int periodic = builder.line(here, here);
  int a1 = builder.line(here, there), a2 = builder.line(there, here);
  int b1 = builder.line(here, beyond), b2 = builder.line(beyond, here);
  builder.face(std::make_shared<fake::Cylinder>(1), 1,
               {{builder.use(periodic, true, {0, 0}, {0, 1}), builder.use(a1, false, {0, 0}, {3, 0}),
                 builder.use(a2, false, {3, 0}, {full, 0}), builder.use(periodic, false, {full, 0}, {full, 1}),
                 builder.use(b1, false, {full, 1}, {3, 1}), builder.use(b2, false, {3, 1}, {0, 1})}});
  Model model = builder.take();
  EXPECT_EQ(edges_of(linked_loops(model, 0)), (Edges{{a1, a2}, {b1, b2}}));
}

// Loops through four vertices that go on at random where they meet, without the edges that are used both ways: many
// chains are open at one vertex, and all must close.
TEST(LinkedLoops, ChainsThatAreOpenAtOneVertexClose) {
  std::mt19937 random(1);
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  for (int trial = 0; trial < 20000; ++trial) {
    fake::Builder builder;
    std::vector<int> vertices;
    for (double x : {0.0, 1.0, 2.0, 3.0}) vertices.push_back(builder.vertex({x, 0, 0}));
    struct Use {
      Coedge coedge;
      int from, to;
      bool is_dropped;
    };
    std::vector<Use> uses;
    auto add = [&](int edge, bool is_reversed, int from, int to, bool is_dropped) {
      uses.push_back({builder.use(edge, is_reversed, {0, 0}, {1, 0}), from, to, is_dropped});
    };
    for (int i = 1 + below(5); i > 0; --i) {
      const int from = vertices[below(4)], to = vertices[below(4)], edge = builder.line(from, to);
      add(edge, false, from, to, true), add(edge, true, to, from, true);
    }
    std::size_t kept = 0;
    for (int i = 1 + below(4); i > 0; --i) {
      const int first = vertices[below(4)], second = vertices[below(4)];
      add(builder.line(first, second), false, first, second, false);
      add(builder.line(second, first), false, second, first, false);
      kept += 2;
    }
    std::vector<std::size_t> order(uses.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::shuffle(order, random);
    std::vector<bool> is_done(uses.size(), false), is_entered(uses.size(), false);
    std::vector<std::vector<Coedge>> loops;
    std::vector<std::vector<bool>> is_dropped;
    for (std::size_t start = 0; start < uses.size(); ++start) {
      if (is_done[start]) continue;
      loops.emplace_back(), is_dropped.emplace_back();
      for (std::size_t at = start; !is_done[at];) {
        is_done[at] = true;
        loops.back().push_back(uses[at].coedge), is_dropped.back().push_back(uses[at].is_dropped);
        at = *std::ranges::find_if(order, [&](std::size_t k) { return !is_entered[k] && uses[k].from == uses[at].to; });
        is_entered[at] = true;
      }
    }
    builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 1, loops);
    const Model model = builder.take();
    std::size_t count = 0;
    for (const Loop& linked : linked_loops(model, 0, is_dropped)) {
      const std::size_t n = linked.coedges.size();
      count += n;
      for (std::size_t i = 0; i < n; ++i) {
        const Coedge &use = linked.coedges[i], &next = linked.coedges[(i + 1) % n];
        ASSERT_EQ(end_of(model.edges[use.edge], use), start_of(model.edges[next.edge], next)) << trial;
      }
    }
    ASSERT_EQ(count, kept) << trial;
  }
}

// A ring whose hole is a point, turned by half: both circles and both poles are at one vertex.
TEST(LinkedLoops, CirclesWithAPoleBetweenThemAreOneLoop) {
  fake::Builder builder;
  const double full = 2 * fake::pi;
  const int centre = builder.vertex({0, 0, 0});
  const int near = builder.arc({1, 0, 0}, 1, fake::pi, 3 * fake::pi, centre, centre);
  const int far = builder.arc({-1, 0, 0}, 1, 0, full, centre, centre);
  const int low = builder.pole(centre), high = builder.pole(centre);
  builder.face(
      std::make_shared<fake::Cylinder>(1), 1,
      {{builder.use(low, false, {0, 0}, {fake::pi, 0}), builder.use(far, false, {fake::pi, 0}, {fake::pi, full}),
        builder.use(high, true, {0, full}, {fake::pi, full}), builder.use(near, true, {0, 0}, {0, full})}});
  const Model model = builder.take();
  EXPECT_EQ(edges_of(linked_loops(model, 0)), (Edges{{far, near}}));
}

TEST(LinkedLoops, ASlitInAPlaneStays) {
  fake::Builder builder;
  int a = builder.vertex({0, 0, 0}), b = builder.vertex({2, 0, 0}), c = builder.vertex({0, 2, 0});
  int tip = builder.vertex({0.5, 0.5, 0});
  int ab = builder.line(a, b), bc = builder.line(b, c), ca = builder.line(c, a), slit = builder.line(a, tip);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 2,
               {{builder.use(ab, false, {0, 0}, {2, 0}), builder.use(bc, false, {2, 0}, {0, 2}),
                 builder.use(ca, false, {0, 2}, {0, 0}), builder.use(slit, false, {0, 0}, {0.5, 0.5}),
                 builder.use(slit, true, {0, 0}, {0.5, 0.5})}});
  Model model = builder.take();
  EXPECT_EQ(edges_of(linked_loops(model, 0)), (Edges{{ab, bc, ca, slit, slit}}));
}

}  // namespace
}  // namespace paver
