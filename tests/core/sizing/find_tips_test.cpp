#include <gtest/gtest.h>

#include "sizing/parts/find_places.h"
#include "sizing/parts/local_sizes.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Three sides up to vertex 3, over an equilateral base with corners at a distance of 1; edges 3 to 5 lead up.
Model spike(double height, bool has_base = true) {
  fake::Builder builder;
  std::vector<Vec3> corner;
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * fake::pi * i / 3;
    corner.push_back({std::cos(angle), std::sin(angle), 0});
    builder.vertex(corner.back());
  }
  const Vec3 top{0, 0, height};
  const int apex = builder.vertex(top);
  for (int i = 0; i < 3; ++i) builder.line(i, (i + 1) % 3);
  for (int i = 0; i < 3; ++i) builder.line(i, apex);
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = corner[static_cast<std::size_t>(i)], b = corner[static_cast<std::size_t>((i + 1) % 3)];
    builder.face(std::make_shared<fake::Plane>(a, b - a, top - a), 1,
                 {{builder.use(i), builder.use(3 + (i + 1) % 3), builder.use(3 + i, true)}});
  }
  if (has_base)
    builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{0, 1, 0}, Vec3{1, 0, 0}), 1,
                 {{builder.use(2, true), builder.use(1, true), builder.use(0, true)}});
  return builder.take();
}

std::vector<int> tips_of(const Model& model) {
  std::vector<int> vertices;
  for (const Tip& tip : find_tips(model)) vertices.push_back(tip.vertex);
  return vertices;
}

TEST(FindTips, ASharpCornerOfABodyIsOne) {
  EXPECT_EQ(tips_of(spike(8)), std::vector<int>{3});
  EXPECT_NEAR(find_tips(spike(8))[0].room, std::sqrt(65.0), 1e-9);
}

TEST(FindTips, CornersOfBoxesAndTetrahedraAreNone) {
  EXPECT_TRUE(tips_of(fake::box(3, 2, 1)).empty());
  EXPECT_TRUE(tips_of(spike(M_SQRT2)).empty());
}

TEST(FindTips, CornersOfAThinWedgeAre) { EXPECT_EQ(tips_of(spike(0.5)), (std::vector<int>{0, 1, 2})); }

TEST(FindTips, WhereTheSurfaceEndsThereIsNone) {
  EXPECT_EQ(tips_of(spike(8, false)), std::vector<int>{3});
  Model open = spike(8);
  open.edges[4].faces.pop_back();
  EXPECT_TRUE(tips_of(open).empty());
  Model junction = spike(8);
  junction.edges[4].faces.push_back(3);
  EXPECT_TRUE(tips_of(junction).empty());
}

TEST(FindTips, SmoothPolesAreNone) { EXPECT_TRUE(tips_of(fake::ball(3)).empty()); }

Options by_size(double h, double tip) {
  Options options;
  options.size = h;
  options.tip = tip;
  return options;
}

TEST(Tips, TakeAShareOfTheLength) {
  const LocalSizes sizes(spike(8), by_size(1, 4), 1);
  EXPECT_DOUBLE_EQ(sizes.at({0, 0, 8}), 0.25);
  EXPECT_NEAR(sizes.at({0, 0, 7}), 0.25 + Options().gradation, 1e-12);
}

TEST(Tips, AreLeftAloneWhereThatChangesNothing) {
  EXPECT_TRUE(LocalSizes(spike(8), by_size(1, 1), 1).is_empty());
  EXPECT_TRUE(LocalSizes(spike(8), by_size(100, 4), 100).is_empty());  // all edges are shorter
  EXPECT_TRUE(LocalSizes(fake::box(3, 2, 1), by_size(1, 4), 1).is_empty());
}

TEST(Tips, ALengthGivenForTheVertexHolds) {
  Model model = spike(8);
  model.read_vertices = model.vertices;
  model.read_edges = static_cast<int>(model.edges.size());
  Options options = by_size(1, 4);
  options.local = {{"Vertex4", 0.6}};
  EXPECT_DOUBLE_EQ(LocalSizes(model, options, 1).at({0, 0, 8}), 0.6);
}

}  // namespace
}  // namespace paver
