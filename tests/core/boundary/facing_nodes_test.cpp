// Nodes opposite the vertices across narrow faces.
#include "boundary/facing/facing_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "boundary/region_loops.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Equal intervals on every edge.
NodeLengths even(const Model& model, const std::vector<int>& counts) {
  NodeLengths lengths;
  for (std::size_t e = 0; e < counts.size(); ++e) {
    lengths.emplace_back();
    for (int i = 0; i <= counts[e]; ++i) lengths.back().push_back(model.edges[e].length * i / counts[e]);
  }
  return lengths;
}

std::vector<MovedNodes> moved_in(
    const Model& model, const std::vector<int>& counts,
    const MayMove& may_move = [](const MovedNodes&) { return true; }) {
  std::vector<std::vector<Loop>> loops;
  for (std::size_t f = 0; f < model.faces.size(); ++f) loops.push_back(linked_loops(model, static_cast<int>(f)));
  const auto point = [&](int edge, double length) {
    return model.edges[edge].curve->point(model.edges[edge].parameter(length / model.edges[edge].length));
  };
  return face_vertices(model, find_opposite_sides(model, loops), even(model, counts),
                       std::vector<bool>(model.edges.size(), false), may_move, point);
}

double nearest(const std::vector<double>& places, double place) {
  double least = INFINITY;
  for (double p : places) least = std::min(least, std::fabs(p - place));
  return least;
}

/// The end of a board 30 wide: edge 0 below; on top edges 2 to 4, a trace of 0.5 between the others.
Model end_of_board(double height) {
  return fake::polygon(
      {{0, 0, 0}, {30, 0, 0}, {30, height, 0}, {15.25, height, 0}, {14.75, height, 0}, {0, height, 0}});
}

TEST(FacingNodes, AnEvenEdgeMovesItsNodesNextToTheVerticesItFaces) {
  const std::vector<MovedNodes> moved = moved_in(end_of_board(0.25), {5, 1, 2, 1, 2, 1});
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].edge, 0);
  EXPECT_EQ(moved[0].lengths.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(moved[0].lengths));
  for (double vertex : {14.75, 15.25}) EXPECT_LE(nearest(moved[0].lengths, vertex), 0.25 + 1e-9);
  for (std::size_t i = 1; i < moved[0].lengths.size(); ++i)
    EXPECT_GE(moved[0].lengths[i] - moved[0].lengths[i - 1], 0.5);
}

// Edges 0 and 1 below, which meet at 20; on top from 30 back edges 3 to 5, which meet at 10.5 and 10.
TEST(FacingNodes, VerticesOfBothSidesHaveNodesOpposite) {
  const Model model =
      fake::polygon({{0, 0, 0}, {20, 0, 0}, {30, 0, 0}, {30, 0.25, 0}, {10.5, 0.25, 0}, {10, 0.25, 0}, {0, 0.25, 0}});
  const std::vector<MovedNodes> moved = moved_in(model, {3, 1, 1, 2, 1, 1, 1});
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0].edge, 0);
  for (double vertex : {10.0, 10.5}) EXPECT_LE(nearest(moved[0].lengths, vertex), 0.25 / 2 + 1e-9);
  EXPECT_EQ(moved[1].edge, 3);
  EXPECT_LE(nearest(moved[1].lengths, 30 - 20), 0.25 / 2 + 1e-9);
}

TEST(FacingNodes, NoneMovesWhereVerticesOfBothSidesWouldCross) {
  const Model model = fake::polygon({{0, 0, 0}, {20, 0, 0}, {30, 0, 0}, {30, 0.25, 0}, {10, 0.25, 0}, {0, 0.25, 0}});
  EXPECT_TRUE(moved_in(model, {2, 3, 1, 1, 4, 1}).empty())
      << "the fourth node on top lies at 10, the second below at 20";
}

TEST(FacingNodes, RowsThatLeanLittleStay) {
  const Model model = fake::polygon({{0, 0, 0}, {4, 0, 0}, {4, 0.3, 0}, {2.1, 0.3, 0}, {0, 0.3, 0}});
  EXPECT_TRUE(moved_in(model, {4, 1, 2, 2, 1}).empty());
}

// An arc below, and on top two straight edges that meet above a third of it.
TEST(FacingNodes, TheLongerSideOfACrescentFacesTheVerticesOfTheShorterOne) {
  fake::Builder builder;
  const double deep = 0.5, radius = (15 * 15 + deep * deep) / (2 * deep), half = std::asin(15 / radius);
  const int left = builder.vertex({0, 0, 0}), right = builder.vertex({30, 0, 0}), between = builder.vertex({10, 0, 0});
  const int arc = builder.arc({15, radius - deep, 0}, radius, -0.5 * fake::pi - half, -0.5 * fake::pi + half, left,
                              right),
            longer = builder.line(right, between), shorter = builder.line(between, left);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 10,
               {{builder.use(arc), builder.use(longer), builder.use(shorter)}});
  std::vector<int> counts(3);
  counts[arc] = 3, counts[longer] = 1, counts[shorter] = 2;
  const std::vector<MovedNodes> moved = moved_in(builder.take(), counts);
  const auto at = std::ranges::find(moved, arc, &MovedNodes::edge);
  ASSERT_NE(at, moved.end());
  EXPECT_NEAR(at->lengths[2], 10, 0.1);
  EXPECT_NEAR(at->lengths[1], 5, 0.1);
}

TEST(FacingNodes, WideFacesAndUnequalSidesAreLeftAlone) {
  EXPECT_TRUE(moved_in(end_of_board(12), {5, 2, 2, 1, 2, 2}).empty());
  EXPECT_TRUE(moved_in(end_of_board(0.25), {4, 1, 2, 1, 2, 1}).empty());
}

/// Flat ring: edge 0 outside, anticlockwise for `way` = 1; inside edges 1 and 2 from `start` radians on, which meet
/// after another 1.9.
Model ring(double outer, double inner, double way, double start) {
  fake::Builder builder;
  const int rim = builder.vertex({outer, 0, 0});
  builder.edge(std::make_shared<fake::Ellipse>(Vec3{}, outer, way * outer), 0, 2 * fake::pi, rim, rim,
               2 * fake::pi * outer);
  auto at = [&](double angle) { return builder.vertex({inner * std::cos(angle), inner * std::sin(angle), 0}); };
  const int a = at(start), b = at(start + 1.9);
  builder.arc({}, inner, start, start + 1.9, a, b);
  builder.arc({}, inner, start + 1.9, start + 2 * fake::pi, b, a);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}),
               fake::pi * (outer * outer - inner * inner),
               {{builder.use(0, way < 0)}, {builder.use(2, true), builder.use(1, true)}});
  return builder.take();
}

TEST(FacingNodes, RimsOfNarrowRingsFaceEachOthersVertices) {
  for (double way : {1.0, -1.0}) {
    const std::vector<MovedNodes> moved = moved_in(ring(15, 14, way, 0), {8, 2, 6});
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_EQ(moved[0].edge, 0);
    EXPECT_TRUE(std::ranges::is_sorted(moved[0].lengths));
    EXPECT_LE(nearest(moved[0].lengths, 15 * (way > 0 ? 1.9 : 2 * fake::pi - 1.9)), 1 + 1e-9);
  }
}

TEST(FacingNodes, RimsWhoseVerticesLieApartFaceEachOthersToo) {
  for (double way : {1.0, -1.0}) {
    const std::vector<MovedNodes> moved = moved_in(ring(15, 14, way, 0.4), {8, 2, 6});
    ASSERT_EQ(moved.size(), 2u);
    for (const MovedNodes& edge : moved) EXPECT_TRUE(std::ranges::is_sorted(edge.lengths));
    EXPECT_EQ(moved[0].edge, 0);
    for (double vertex : {0.4, 2.3})
      EXPECT_LE(nearest(moved[0].lengths, 15 * (way > 0 ? vertex : 2 * fake::pi - vertex)), 0.5 + 1e-6) << way;
    EXPECT_EQ(moved[1].edge, 2);
    EXPECT_LE(nearest(moved[1].lengths, 14 * (2 * fake::pi - 2.3)), 0.5 + 1e-6) << way;
  }
}

TEST(FacingNodes, WideRingsStay) { EXPECT_TRUE(moved_in(ring(15, 5, 1, 0.4), {8, 2, 6}).empty()); }

TEST(FacingNodes, WhatFacesAMovedEdgeFollowsIt) {
  fake::Builder builder;
  for (Vec3 corner : {Vec3{0, 0, 0}, {30, 0, 0}, {30, 0.25, 0}, {15.25, 0.25, 0}, {14.75, 0.25, 0}, {0, 0.25, 0}})
    builder.vertex(corner);
  builder.vertex({0, -0.1, 0});
  builder.vertex({30, -0.1, 0});
  auto plane = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  std::vector<Coedge> board, metal;
  std::vector<Vec2> at = {{0, 0}, {30, 0}, {30, 0.25}, {15.25, 0.25}, {14.75, 0.25}, {0, 0.25}, {0, -0.1}, {30, -0.1}};
  auto image = [&](int edge, bool is_reversed, std::size_t a, std::size_t b) {
    return builder.use(edge, is_reversed, at[a], at[b]);
  };
  for (int i = 0; i < 6; ++i)
    board.push_back(image(builder.line(i, (i + 1) % 6), false, static_cast<std::size_t>(i), (i + 1u) % 6));
  metal.push_back(image(0, true, 0, 1));
  metal.push_back(image(builder.line(0, 6), false, 0, 6));
  metal.push_back(image(builder.line(6, 7), false, 6, 7));
  metal.push_back(image(builder.line(7, 1), false, 7, 1));
  builder.face(plane, 30 * 0.1, {metal});
  builder.face(plane, 30 * 0.25, {board});
  const Model model = builder.take();
  const std::vector<int> counts = {5, 1, 2, 1, 2, 1, 1, 5, 1};
  EXPECT_TRUE(moved_in(model, counts, [](const MovedNodes& edge) { return edge.edge != 0; }).empty())
      << "edge 7 would have nothing to follow";
  const std::vector<MovedNodes> moved = moved_in(model, counts);
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_EQ(moved[0].edge, 0);
  EXPECT_EQ(moved[1].edge, 7);
  for (std::size_t i = 0; i < moved[0].lengths.size(); ++i)
    EXPECT_LE(std::fabs(moved[0].lengths[i] - moved[1].lengths[i]), 0.1 + 1e-9);
}

// By equal shares both chords at the tip would be one line.
TEST(FacingNodes, NodesOfAMoonLieWhereThoseOfItsLongerSideAreNearest) {
  const double outer = 10, inner = 9, pi = fake::pi;
  const int count = 24;
  const std::vector<MovedNodes> moved = moved_in(fake::moon(outer, inner), {count, count});
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].edge, 1);
  for (int i = 1; i < count; ++i) {
    const double angle = 2 * pi * i / count;
    const double x = outer * std::cos(angle) - (outer - inner), y = outer * std::sin(angle);
    const double opposite = std::atan2(y, x);
    EXPECT_NEAR(moved[0].lengths[static_cast<std::size_t>(i)], inner * (opposite < 0 ? opposite + 2 * pi : opposite),
                1e-4);
  }
  EXPECT_TRUE(moved_in(fake::moon(outer, inner), {count + 2, count}).empty()) << "unequal counts";
  EXPECT_TRUE(moved_in(fake::moon(outer, 5), {count, count}).empty()) << "wide";
}

}  // namespace
}  // namespace paver
