#include "boundary/edge_nodes.h"

#include <gtest/gtest.h>

#include "boundary/region_loops.h"
#include "support/alone.h"
#include "support/fake_model.h"

namespace paver {
namespace {

SizeField size_of(const Model& model, double h, double turn_limit = 0.7853981633974483) {
  SizeField size;
  size.h = h;
  size.turn_limit = turn_limit;
  size.faces.assign(model.faces.size(), FaceSize(h));
  size.face_h.assign(model.faces.size(), h);
  return size;
}

std::vector<int> counts_of(const Model& model, double h) {
  Progress progress;
  test::Alone alone(progress);
  return choose_counts(model, size_of(model, h), progress, alone).count;
}

EdgeNodes nodes_of(const Model& model, double h) {
  Progress progress;
  test::Alone alone(progress);
  return divide_edges(model, size_of(model, h), choose_counts(model, size_of(model, h), progress, alone), alone);
}

int odd_loops(const Model& model, const std::vector<int>& counts) {
  int odd = 0;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    for (const Loop& loop : linked_loops(model, static_cast<int>(f))) {
      int total = 0;
      for (const Coedge& coedge : loop.coedges) total += counts[static_cast<std::size_t>(coedge.edge)];
      odd += total % 2;
    }
  }
  return odd;
}

TEST(ChooseCounts, ABoxIsDividedByItsLengths) {
  std::vector<int> counts = counts_of(fake::box(1, 2, 3), 0.1);
  EXPECT_EQ(counts, (std::vector<int>{10, 20, 10, 20, 10, 20, 10, 20, 30, 30, 30, 30}));
}

TEST(ChooseCounts, AnEdgeNeverHasLessThanOneInterval) {
  for (int count : counts_of(fake::box(1, 2, 3), 1e6)) EXPECT_EQ(count, 1);
}

TEST(ChooseCounts, OppositeSidesThatRoundDifferentlyAreTied) {
  // 10.4 and 10.6 round to 10 and 11.
  Model model = fake::polygon({{0, 0, 0}, {10.4, 0, 0}, {10.6, 5, 0}, {0, 5, 0}});
  std::vector<int> counts = counts_of(model, 1);
  EXPECT_EQ(counts[0], counts[2]);
  EXPECT_EQ(counts[1], counts[3]);
}

TEST(ChooseCounts, ATriangleComesOutEven) {
  Model model = fake::polygon({{0, 0, 0}, {9, 0, 0}, {4.5, 7.8, 0}});
  EXPECT_EQ(odd_loops(model, counts_of(model, 1)), 0);
}

TEST(ChooseCounts, ASmallCircleKeepsFourIntervals) {
  for (double h : {1e-1, 1.0, 100.0}) {
    std::vector<int> counts = counts_of(fake::tube(0.01, 1), h);
    EXPECT_GE(counts[0], 8) << "a turn of 45 degrees each";
    EXPECT_EQ(counts[0], counts[2]);
  }
  Progress progress;
  test::Alone alone(progress);
  Model tube = fake::tube(0.01, 1);
  EXPECT_EQ(choose_counts(tube, size_of(tube, 1, 3.0), progress, alone).count[0], 4);
}

TEST(ChooseCounts, NoIntervalOfAnEllipseTurnsMoreThanTheLimit) {
  fake::Builder builder;
  int v = builder.vertex({5, 0, 0});
  int ring = builder.edge(std::make_shared<fake::Ellipse>(Vec3{}, 5, 0.5), 0, 2 * fake::pi, v, v, 20);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 7.85, {{builder.use(ring)}});
  Model model = builder.take();
  EdgeNodes nodes = nodes_of(model, 100);
  const EdgeDivision& division = nodes.edges[0];
  for (std::size_t i = 0; i + 2 < division.t.size(); i += 2) {
    const Vec3 a = model.edges[0].curve->slope(division.t[i]).t, b = model.edges[0].curve->slope(division.t[i + 2]).t;
    EXPECT_LE(std::acos(dot(unit(a), unit(b))), 0.7853981633974483 * 1.01);
  }
}

TEST(ChooseCounts, ALensGetsTwoIntervalsOnOneOfItsEdges) {
  fake::Builder builder;
  int a = builder.vertex({0, 0, 0}), b = builder.vertex({1, 0, 0});
  int chord = builder.line(a, b), other = builder.line(a, b);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 0.1,
               {{builder.use(chord), builder.use(other, true)}});
  std::vector<int> counts = counts_of(builder.take(), 10);
  EXPECT_GE(std::max(counts[0], counts[1]), 2);
}

TEST(ChooseCounts, AFaceThatCannotBeMeshedAsksForNoParity) {
  Model model = fake::polygon({{0, 0, 0}, {9, 0, 0}, {4.5, 7.8, 0}});
  model.faces[0].fault = "no curve";
  EXPECT_EQ(counts_of(model, 1), (std::vector<int>{9, 9, 9}));
}

TEST(ChooseCounts, PolesAreNotDivided) {
  std::vector<int> counts = counts_of(fake::ball(1), 0.2);
  EXPECT_GT(counts[0], 0);
  EXPECT_EQ(counts[1], 0);
  EXPECT_EQ(counts[2], 0);
}

TEST(DivideEdges, AllEdgesShareTheVertexNodes) {
  Model box = fake::box(1, 2, 3);
  EdgeNodes nodes = nodes_of(box, 0.1);
  ASSERT_EQ(nodes.nodes.size(), 8u + 4 * (9 + 19 + 29));
  EXPECT_EQ(nodes.node_edge.size(), nodes.nodes.size());
  EXPECT_EQ(nodes.node_target.size(), nodes.nodes.size());
  for (std::size_t e = 0; e < box.edges.size(); ++e) {
    const EdgeDivision& division = nodes.edges[e];
    ASSERT_EQ(division.t.size(), 2 * division.node.size() - 1);
    EXPECT_EQ(division.node.front(), box.edges[e].start);
    EXPECT_EQ(division.node.back(), box.edges[e].end);
    EXPECT_EQ(division.t.front(), box.edges[e].t0);
    EXPECT_EQ(division.t.back(), box.edges[e].t1);
    for (std::size_t i = 0; i < division.node.size(); ++i) {
      EXPECT_EQ(division.x[2 * i], nodes.nodes[static_cast<std::size_t>(division.node[i])]);
    }
  }
}

TEST(DivideEdges, IntervalsAndMiddlesAreEqualOnACircle) {
  EdgeNodes nodes = nodes_of(fake::tube(1, 1), 0.25);
  const EdgeDivision& division = nodes.edges[0];
  double step = 2 * fake::pi / (2 * division.intervals());
  for (std::size_t i = 0; i < division.t.size(); ++i) {
    EXPECT_NEAR(division.t[i], step * static_cast<double>(i), 1e-9);
  }
  EXPECT_EQ(division.node.front(), division.node.back());
}

TEST(DivideEdges, PolesAndTheirVerticesTakeNoNodesOfTheirOwn) {
  EdgeNodes nodes = nodes_of(fake::ball(1), 0.5);
  EXPECT_EQ(nodes.edges[1].intervals(), 0);
  EXPECT_EQ(nodes.nodes.size(), 2u + static_cast<std::size_t>(nodes.edges[0].intervals() - 1));
}

TEST(DivideEdges, EdgesWithACountOfZeroAreLeftOut) {
  Model box = fake::box(1, 1, 1);
  std::vector<int> counts(12, 0);
  counts[4] = 3;
  Progress progress;
  test::Alone alone(progress);
  EdgeNodes nodes = divide_edges(box, size_of(box, 0.3), {counts, {}}, alone);
  EXPECT_EQ(nodes.nodes.size(), 4u);
  EXPECT_EQ(nodes.edges[4].node, (std::vector<int>{0, 2, 3, 1}));
}

// The base of a comb: a node opposite each corner between its teeth.
TEST(DivideEdges, NodesLieOppositeTheVerticesOfAComb) {
  const Model comb =
      fake::polygon({{0, 0, 0}, {50, 0, 0}, {50, 2, 0}, {32, 2, 0}, {32, 30, 0}, {30, 30, 0}, {30, 2, 0}, {0, 2, 0}});
  const EdgeNodes nodes = nodes_of(comb, 1000);
  std::vector<double> places;
  for (int node : nodes.edges[0].node) places.push_back(nodes.nodes[node].x);
  ASSERT_EQ(places.size(), 4u);
  EXPECT_NEAR(places[1], 30, 1e-9);
  EXPECT_NEAR(places[2], 32, 1e-9);
}

}  // namespace
}  // namespace paver
