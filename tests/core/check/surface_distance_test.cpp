#include "check/distance/surface_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "curving/place_nodes.h"
#include "support/boundary_use.h"
#include "support/fake_model.h"
#include "support/paved_model.h"

namespace paver {
namespace {

Options options_of(double h) {
  Options options;
  options.size = h;
  return options;
}

struct Measured : test::PavedModel {
  Measured(Model m, double h, int order) : PavedModel(std::move(m), options_of(h)), target(h) {
    for (std::size_t i = 0; i < regions.size(); ++i) parts.push_back({&regions[i], &paved[i]});
    joined = join_regions(model, edges, test::all_of(edges), parts);
    for (std::size_t i = 0; i < regions.size(); ++i) parts[i].node_of = &joined.node_of[i];
    mesh =
        order == 1
            ? joined.mesh
            : curve_elements(joined.mesh, {joined.sizes, edges, model, Cuts(regions, {}), parts, 1}, Progress()).mesh;
  }
  std::vector<SurfaceDistance> run(int threads = 1) const { return measured(INFINITY, threads).faces; }
  MeshDistances measured(double most, int threads = 1) const {
    SingleRank one;
    return measure_distances({model, edges, mesh, parts, joined.sizes, target, threads, most}, Progress(), one);
  }

  double target;
  JoinedMesh joined;
  std::vector<MeshPart> parts;
  SurfaceMesh mesh;
};

/// A disc in the plane: its border is one circle.
Model disc(double radius) {
  fake::Builder builder;
  const int start = builder.vertex({radius, 0, 0});
  const int circle = builder.arc({}, radius, 0, 2 * fake::pi, start, start);
  Coedge use = builder.use(circle);
  struct Image : ParameterCurve {
    double radius;
    explicit Image(double r) : radius(r) {}
    Vec2 uv(double t) const override { return {radius * std::cos(t), radius * std::sin(t)}; }
  };
  use.pcurve = std::make_shared<Image>(radius);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), fake::pi * radius * radius,
               {{use}});
  return builder.take();
}

TEST(SurfaceDistance, OfStraightElementsRoundATubeIsThatOfTheirChords) {
  const Measured tube(fake::tube(4, 10), 1.5, 1);
  const int around = tube.edges.edges[0].intervals();
  const SurfaceDistance d = tube.run()[0];
  const double sagitta = 4 * (1 - std::cos(fake::pi / around));
  EXPECT_GT(d.largest, 0.9 * sagitta);
  EXPECT_LT(d.largest, 1.6 * sagitta);  // diagonals of elements that lean
  EXPECT_GT(d.mean, 0.5 * sagitta);
  EXPECT_LT(d.mean, d.largest);
  EXPECT_GT(d.angle, 0.4 * fake::pi / around);
  EXPECT_LT(d.angle, 1.6 * fake::pi / around);
}

TEST(SurfaceDistance, FallsFastWithTheLengthAtOrderTwo) {
  const double coarse = Measured(fake::tube(4, 10), 1.5, 2).run()[0].largest;
  const double fine = Measured(fake::tube(4, 10), 0.75, 2).run()[0].largest;
  EXPECT_LT(coarse, 4e-3);
  EXPECT_LT(fine, 0.15 * coarse);
  EXPECT_GT(fine, 0.02 * coarse);
}

TEST(SurfaceDistance, OfAFlatFaceIsThatOfItsSides) {
  const Measured polygon(fake::polygon({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {1, 4, 0}}), 1, 2);
  EXPECT_LT(polygon.run()[0].largest, 1e-12);
  EXPECT_EQ(polygon.run()[0].angle, 0);
  const Measured round(disc(5), 2, 2);
  const double angle = fake::pi / round.edges.edges[0].intervals();
  // A parabola through three points of a circle misses it half way by this, to leading order.
  const double missed = 5 * 3 * std::pow(angle, 4) / 128;
  EXPECT_NEAR(round.run()[0].largest, missed, 0.05 * missed);
  const Measured straight(disc(5), 2, 1);
  EXPECT_NEAR(straight.run()[0].largest, 5 * (1 - std::cos(angle)), 0.05 * angle * angle);
}

TEST(SurfaceDistance, IsTheSameOnAnyNumberOfThreads) {
  const Measured ball(fake::ball(3), 0.8, 2);
  const SurfaceDistance one = ball.run(1)[0], three = ball.run(3)[0];
  EXPECT_EQ(one.largest, three.largest);
  EXPECT_EQ(one.mean, three.mean);
  EXPECT_EQ(one.angle, three.angle);
  EXPECT_GT(one.mean, 0);
}

TEST(SurfaceDistance, OfSeveralFacesIsWeighedByTheirElements) {
  const SurfaceDistance joined = join_distances({2, 1, 0.1}, 30, {1, 0.5, 0.2}, 10);
  EXPECT_EQ(joined.largest, 2);
  EXPECT_DOUBLE_EQ(joined.mean, 0.875);
  EXPECT_EQ(joined.angle, 0.2);
  EXPECT_EQ(join_distances({}, 0, {}, 0).mean, 0);
}

TEST(SurfaceDistance, ListsWhatIsFartherOff) {
  const Measured tube(fake::tube(4, 10), 1.5, 1);
  const MeshDistances all = tube.measured(0), some = tube.measured(0.5 * all.faces[0].largest),
                      none = tube.measured(all.faces[0].largest);
  auto count = [](const MeshDistances& d, bool is_side) {
    return std::count_if(d.far.begin(), d.far.end(), [&](const FarPlace& p) { return (p.corners == 2) == is_side; });
  };
  EXPECT_EQ(count(all, false), static_cast<long>(tube.mesh.quad_count()));
  long sides = 0;  // on each face of its edge
  for (std::size_t e = 0; e < tube.model.edges.size(); ++e)
    if (const Edge& edge = tube.model.edges[e]; edge.curve && !edge.is_periodic)
      sides += static_cast<long>(edge.faces.size()) * tube.edges.edges[e].intervals();
  EXPECT_EQ(count(all, true), sides);
  EXPECT_GT(some.far.size(), 0u);
  for (const FarPlace& place : some.far) {
    EXPECT_GT(place.distance, 0.5 * all.faces[0].largest);
    for (int k = 0; k < place.corners; ++k) EXPECT_NEAR(std::hypot(place.x[k].x, place.x[k].y), 4, 1e-9);
  }
  EXPECT_TRUE(none.far.empty());
}

}  // namespace
}  // namespace paver
