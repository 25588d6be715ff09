#include "check/distance/element_patch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace paver {
namespace {

/// A quad of order 2 on the cylinder of radius 1 about z, from angle 0 to `angle`, 0 <= z <= 1, moved by `by`.
ElementPatch round_quad(double angle, Vec3 by = {}, double radius = 1) {
  ElementPatch quad;
  for (int k = 0; k < 9; ++k) {
    const Vec2 uv = quad.node_place(k);
    quad.nodes[k] = by + Vec3{radius * std::cos(angle * uv.x), radius * std::sin(angle * uv.x), uv.y};
  }
  return quad;
}

TEST(ElementPatch, ItPassesThroughItsNodes) {
  for (int corners : {2, 3, 4})
    for (int order : {1, 2}) {
      ElementPatch patch{corners, order, {}};
      for (int k = 0; k < patch.node_count(); ++k) patch.nodes[k] = {std::sin(k), std::cos(3 * k), 0.1 * k * k};
      for (int k = 0; k < patch.node_count(); ++k)
        EXPECT_LT(norm(patch.at(patch.node_place(k)) - patch.nodes[k]), 1e-14) << corners << order << k;
    }
}

TEST(ElementPatch, ItsSlopesAreThoseOfItsPlaces) {
  for (int corners : {2, 3, 4})
    for (int order : {1, 2}) {
      ElementPatch patch{corners, order, {}};
      for (int k = 0; k < patch.node_count(); ++k) patch.nodes[k] = {std::sin(k), std::cos(3 * k), 0.1 * k * k};
      const Vec2 at{0.3, corners == 2 ? 0 : 0.4};
      constexpr double step = 1e-6;
      const auto [u, v] = patch.slopes(at);
      EXPECT_LT(norm((0.5 / step) * (patch.at(at + Vec2{step, 0}) - patch.at(at - Vec2{step, 0})) - u), 1e-8);
      if (corners == 2) continue;
      EXPECT_LT(norm((0.5 / step) * (patch.at(at + Vec2{0, step}) - patch.at(at - Vec2{0, step})) - v), 1e-8);
    }
}

TEST(ElementPatch, TheNearestPlaceMayBeInsideOnASideOrACorner) {
  const ElementPatch quad = round_quad(1);
  EXPECT_NEAR(norm(quad.at(quad.nearest({2 * std::cos(0.3), 2 * std::sin(0.3), 0.4}, {0.5, 0.5})) -
                   Vec3{std::cos(0.3), std::sin(0.3), 0.4}),
              0, 5e-3);  // what order 2 leaves of a radian
  EXPECT_LT(norm(quad.at(quad.nearest({1, 0, 3}, {0.5, 0.5})) - Vec3{1, 0, 1}), 1e-9);
  EXPECT_LT(norm(quad.at(quad.nearest({2, -1, -1}, {0.5, 0.5})) - Vec3{1, 0, 0}), 1e-9);
  ElementPatch triangle{3, 1, {Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_LT(norm(triangle.at(triangle.nearest({0.9, 0.7, 1}, {0, 0})) - Vec3{0.6, 0.4, 0}), 1e-9);
}

TEST(ElementPatch, DistancesBetweenPatchesAreNotThoseOfTheirNodes) {
  ElementPatch a{2, 1, {Vec3{-1, 0, 0}, {2, 0, 0}}}, b{2, 1, {Vec3{0.3, -2, 0.25}, {0.3, 1, 0.25}}};
  const PatchDistance lines = distance(a, b);
  EXPECT_NEAR(lines.distance, 0.25, 1e-9);
  EXPECT_LT(norm(lines.where - Vec3{0.3, 0, 0}), 1e-6);
  // A plane beside a cylinder comes nearest along a line that is no node's.
  ElementPatch plane{4, 1, {Vec3{1.01, -3, -1}, {1.01, 4, -1}, {1.01, 4, 2}, {1.01, -3, 2}}};
  EXPECT_NEAR(distance(round_quad(1), plane).distance, 0.01, 1e-9);
  EXPECT_NEAR(distance(round_quad(0.5), round_quad(0.5, {}, 1.05)).distance, 0.05, 1e-3);
}

TEST(ElementPatch, PlanesPartPatches) {
  const ElementPatch needle{3, 1, {Vec3{0, 0, 0}, {10, 0, 0}, {10, 0.1, 0}}};
  auto quad = [](Vec3 at) {
    return ElementPatch{4, 1, {at, at + Vec3{1, 0, 0}, at + Vec3{1, 0, 1}, at + Vec3{0, 0, 1}}};
  };
  EXPECT_FALSE(are_apart(needle, quad({8, 0.05, -0.5}), 0)) << "crosses it";
  EXPECT_TRUE(are_apart(needle, quad({2, 0.05, -0.5}), 0)) << "beside its long side, within its box";
  EXPECT_FALSE(are_apart(needle, quad({2, 0.05, -0.5}), 0.1)) << "nearer than asked";
  EXPECT_TRUE(are_apart(needle, quad({8, 0.05, 0.2}), 0.1)) << "above it";
  EXPECT_FALSE(are_apart(round_quad(1), round_quad(0.5, {-0.05, 0.1, 0.1}), 0)) << "bent ones cross";
}

}  // namespace
}  // namespace paver
