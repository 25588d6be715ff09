// Lengths that count turns of the normal.
#include <gtest/gtest.h>

#include "mesh/region_mesh.h"

namespace paver {
namespace {

constexpr double radius = 2, weight = 1.5, h = 0.8;

/// A node of a cylinder about z at (angle, height), chart (radius * angle, height).
NodePlace on_cylinder(double angle, double height) {
  const double c = std::cos(angle), s = std::sin(angle);
  NodePlace at;
  at.p = {radius * angle, height};
  at.x = {radius * c, radius * s, height};
  at.xp = {-s, c, 0};
  at.xq = {0, 0, 1};
  at.n = {c, s, 0};
  at.np = {-s / radius, c / radius, 0};
  return at;
}

RegionMesh cylinder() {
  RegionMesh mesh;
  mesh.turn_weight = weight;
  return mesh;
}

TEST(Metric, LengthsAroundAreStretchedAndLengthsAlongAreNot) {
  RegionMesh mesh = cylinder();
  const double step = 1e-3;
  mesh.add_node(on_cylinder(0, 0), h);
  mesh.add_node(on_cylinder(step / radius, 0), h);
  mesh.add_node(on_cylinder(0, step), h);
  const double stretch = std::sqrt(1 + weight * h * weight * h / (radius * radius));
  EXPECT_NEAR(mesh.length(0, 1), stretch * step, 1e-9);
  EXPECT_NEAR(mesh.length(0, 2), step, 1e-15);
  EXPECT_NEAR(norm(mesh.tangent_p(0)), stretch, 1e-12);
  EXPECT_NEAR(norm(mesh.tangent_q(0)), 1, 1e-12);
}

TEST(Metric, PullBackUndoesPush) {
  RegionMesh mesh = cylinder();
  const int node = mesh.add_node(on_cylinder(0.7, 3), h);
  const Vec2 step{0.3, -0.4}, back = mesh.pull_back(node, mesh.push(node, step));
  EXPECT_NEAR(back.x, step.x, 1e-12);
  EXPECT_NEAR(back.y, step.y, 1e-12);
}

TEST(Metric, AFrameRunsCounterClockwiseAsTheChart) {
  RegionMesh mesh = cylinder();
  const int node = mesh.add_node(on_cylinder(0.7, 3), h);
  const MetricFrame frame = mesh.frame(node);
  EXPECT_NEAR(norm(frame.first), 1, 1e-12);
  EXPECT_NEAR(norm(frame.second), 1, 1e-12);
  EXPECT_NEAR(dot(frame.first, frame.second), 0, 1e-12);
  const Vec2 a = mesh.pull_back(node, frame.first), b = mesh.pull_back(node, frame.second);
  EXPECT_GT(cross(a, b), 0);
}

/// A quad whose sides have the given lengths in space, turned by `skew` (a length along its second side).
double jacobian(double around, double along, double skew, double turn_weight) {
  RegionMesh mesh;
  mesh.turn_weight = turn_weight;
  mesh.add_node(on_cylinder(0, 0), h);
  mesh.add_node(on_cylinder(around / radius, skew), h);
  mesh.add_node(on_cylinder(around / radius, along + skew), h);
  mesh.add_node(on_cylinder(0, along), h);
  return scaled_jacobian(mesh, mesh.elements[mesh.add_element({0, 1, 2, 3})]);
}

TEST(Metric, ARectangleIsGoodInBoth) {
  EXPECT_NEAR(jacobian(0.01, 0.08, 0, weight), 1, 1e-6);
  EXPECT_NEAR(jacobian(0.01, 0.08, 0, 0), 1, 1e-6);
}

TEST(Metric, SkewCountsLessAcrossATurnButInSpaceItIsBounded) {
  const double steep = 20;  // what turns count stretches lengths around about eightfold
  const double plain = jacobian(0.01, 0.08, 0.02, 0), turned = jacobian(0.01, 0.08, 0.02, steep);
  EXPECT_GT(turned, plain);
  EXPECT_LE(turned, 1.4 * plain + 1e-12);
  RegionMesh mesh;
  mesh.turn_weight = steep;
  for (const NodePlace& at :
       {on_cylinder(0, 0), on_cylinder(0.005, 0.02), on_cylinder(0.005, 0.1), on_cylinder(0, 0.08)})
    mesh.add_node(at, h);
  const Element& quad = mesh.elements[mesh.add_element({0, 1, 2, 3})];
  const double value = scaled_jacobian(mesh, quad);
  EXPECT_TRUE(has_jacobian(mesh, quad, 0.99 * value));
  EXPECT_FALSE(has_jacobian(mesh, quad, 1.01 * value));
}

TEST(Metric, WithoutANormalOnlySpaceCounts) {
  RegionMesh mesh = cylinder();
  mesh.add_node(on_cylinder(0, 0), h);
  NodePlace apex = on_cylinder(1, 0);
  apex.n = {};
  mesh.add_node(apex, h);
  EXPECT_NEAR(mesh.length(0, 1), norm(mesh.x[1] - mesh.x[0]), 1e-15);
}

}  // namespace
}  // namespace paver
