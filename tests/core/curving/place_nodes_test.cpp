// Curving of small models that went through all stages before it.
#include "curving/place_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "check/distance/surface_distance.h"
#include "quality/jacobian/jacobian.h"
#include "support/boundary_use.h"
#include "support/fake_model.h"
#include "support/paved_model.h"

namespace paver {
namespace {

/// A model meshed up to its straight elements.
struct Meshed : test::PavedModel {
  Meshed(Model m, double h, double max_turn) : PavedModel(std::move(m), options_of(h, max_turn)) {
    for (std::size_t i = 0; i < regions.size(); ++i) parts.push_back({&regions[i], &paved[i]});
    joined = join_regions(model, edges, test::all_of(edges), parts);
    for (std::size_t i = 0; i < regions.size(); ++i) parts[i].node_of = &joined.node_of[i];
  }
  static Options options_of(double h, double max_turn) {
    Options options;
    options.size = h;
    options.max_turn = max_turn;
    return options;
  }
  SurfaceMesh curved(int threads = 1, const Progress& progress = Progress()) const {
    return curve_elements(joined.mesh, {joined.sizes, edges, model, Cuts(regions, {}), parts, threads}, progress).mesh;
  }
  double chord_error_of(const SurfaceMesh& mesh) const { return distances_of(mesh)[0].largest; }
  std::vector<SurfaceDistance> distances_of(const SurfaceMesh& mesh) const {
    SingleRank one;
    return measure_distances({model, edges, mesh, parts, joined.sizes, 1, 1}, Progress(), one).faces;
  }

  JoinedMesh joined;
  std::vector<MeshPart> parts;
};

void expect_sound(const SurfaceMesh& mesh, const std::function<double(Vec3)>& distance) {
  ASSERT_EQ(mesh.order, 2);
  ASSERT_GT(mesh.quad_count(), 10u);
  for (Vec3 x : mesh.nodes) ASSERT_NEAR(distance(x), 0, 1e-9);
  JacobianForm form(ElementShape::quad, 2);
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) {
    Vec3 x[9];
    for (std::size_t k = 0; k < 9; ++k) x[k] = mesh.nodes[static_cast<std::size_t>(mesh.quads[9 * q + k])];
    EXPECT_TRUE(form.is_valid(x)) << q;
  }
}

TEST(CurveElements, AllNodesOfATubeLieOnIt) {
  Meshed tube(fake::tube(4, 10), 1.5, 0.6);
  SurfaceMesh mesh = tube.curved();
  expect_sound(mesh, [](Vec3 x) { return std::hypot(x.x, x.y) - 4; });
  for (double z : {0.0, 10.0}) {  // middles of rim elements lie on the rims
    long on_rim =
        std::count_if(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec3 x) { return std::fabs(x.z - z) < 1e-12; });
    int edge = z == 0 ? 0 : 2;
    EXPECT_EQ(on_rim, 2 * tube.edges.edges[static_cast<std::size_t>(edge)].intervals());
  }
}

TEST(CurveElements, AllNodesOfABallLieOnItAcrossTheCutBetweenItsRegions) {
  Meshed ball(fake::ball(3), 0.8, 0.6);
  EXPECT_EQ(ball.regions.size(), 6u);
  SurfaceMesh mesh = ball.curved();
  expect_sound(mesh, [](Vec3 x) { return norm(x) - 3; });
  long corners = std::count_if(mesh.node_target.begin(), mesh.node_target.end(), [](double h) { return h > 0; });
  long elements = static_cast<long>(mesh.quad_count() + mesh.triangle_count());
  long sides = (4 * static_cast<long>(mesh.quad_count()) + 3 * static_cast<long>(mesh.triangle_count())) / 2;
  EXPECT_EQ(corners - sides + elements, 2);
}

TEST(CurveElements, FlatFacesKeepTheMiddlesOfTheirChords) {
  Meshed flat(fake::polygon({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {1, 4, 0}}), 1, 0.6);
  SurfaceMesh mesh = flat.curved();
  for (std::size_t q = 0; q < mesh.quad_count(); ++q) {
    auto x = [&](std::size_t k) { return mesh.nodes[static_cast<std::size_t>(mesh.quads[9 * q + k])]; };
    for (std::size_t k = 0; k < 4; ++k) EXPECT_LE(norm(x(4 + k) - 0.5 * (x(k) + x((k + 1) % 4))), 1e-12);
    EXPECT_LE(norm(x(8) - 0.25 * (x(0) + x(1) + x(2) + x(3))), 1e-12);
  }
  EXPECT_LE(flat.chord_error_of(mesh), 1e-12);
}

TEST(CurveElements, AnyNumberOfThreadsGivesTheSameNodes) {
  Meshed ball(fake::ball(3), 0.8, 0.6);
  SurfaceMesh one = ball.curved(1), three = ball.curved(3);
  ASSERT_EQ(one.nodes.size(), three.nodes.size());
  for (std::size_t i = 0; i < one.nodes.size(); ++i) ASSERT_EQ(one.nodes[i], three.nodes[i]);
  EXPECT_EQ(one.quads, three.quads);
}

TEST(CurveElements, StopsWhenCancelled) {
  Meshed ball(fake::ball(3), 0.8, 0.6);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(ball.curved(1, progress), Error);
}

TEST(ChordError, FallsWithTheOrderOfTheElementsAndTheirSize) {
  Meshed coarse(fake::tube(4, 10), 3, 0.8), fine(fake::tube(4, 10), 1.5, 0.4);
  double order_1 = coarse.chord_error_of(coarse.joined.mesh);
  double order_2 = coarse.chord_error_of(coarse.curved());
  double order_2_fine = fine.chord_error_of(fine.curved());
  EXPECT_GT(order_1, 0.05);
  EXPECT_LT(order_1, 1);
  EXPECT_LT(order_2, 0.1 * order_1);
  EXPECT_LT(order_2_fine, 0.3 * order_2);
}

}  // namespace
}  // namespace paver
