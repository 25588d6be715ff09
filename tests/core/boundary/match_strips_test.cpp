// Thin strips between arcs: how many intervals their sides get.
#include <gtest/gtest.h>

#include <array>

#include "boundary/facing/raise_counts.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Counts of both arcs of half a ring between these radii, from 5 and 7.
std::array<int, 2> matched(double inner, double outer) {
  Model model;
  model.edges.resize(4);
  for (std::size_t e : {0, 2}) {
    const double radius = e == 0 ? inner : outer;
    model.edges[e].curve = std::make_shared<fake::Ellipse>(Vec3{}, radius, radius);
    model.edges[e].t0 = 0, model.edges[e].t1 = fake::pi, model.edges[e].length = fake::pi * radius;
  }
  model.faces.resize(1);
  model.faces[0].area = 0.5 * fake::pi * (outer * outer - inner * inner);
  std::vector<EdgeCount> counts{{5, 1, 5}, {1, 1, 1}, {7, 1, 7}, {1, 1, 1}};
  match_bent_strips(model, {{0, {0}, {2}, 1, 0}, {0, {1}, {3}, 0, 0}}, counts);
  return {counts[0].count, counts[2].count};
}

TEST(MatchBentStrips, MakesSidesEqualThatBulgeMoreThanTheStripIsWide) {
  EXPECT_EQ(matched(40, 41), (std::array{7, 7}));
}

TEST(MatchBentStrips, LeavesWideStripsToTheirLengths) { EXPECT_EQ(matched(40, 60), (std::array{5, 7})); }

}  // namespace
}  // namespace paver
