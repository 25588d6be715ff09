#include "boundary/region_loops.h"

#include <gtest/gtest.h>

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
