// Sides that fit two by two and are wrong all the same, made by hand.
#include <gtest/gtest.h>

#include "check/checked_mesh.h"
#include "check/sides/sides_impl.h"
#include "core/check/checked_model.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

// Two quads with the same corners, back to back: every side is in two elements that run opposite.
TEST(CheckSides, FindsElementsWithTheSameCorners) {
  const Model model = fake::ball(1);
  SurfaceMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.quads = {0, 1, 2, 3, 2, 1, 0, 3};
  mesh.quad_face = {0, 0};
  Region region;
  region.face = 0;
  const RegionMesh own;
  const std::vector<MeshPart> parts{{&region, &own, nullptr}};
  const EdgeNodes edges;
  for (int shared : {0, 4}) {  // inside one part, and between parts
    const std::vector<PartSizes> sizes{{4 - shared, 2, 0}};
    const CheckedMesh checked{model, edges, mesh, parts, sizes, {}, {}, shared, {1}};
    MeshFaults faults;
    SingleRank alone;
    check_sides(checked, 1, Progress(), alone, faults);
    EXPECT_EQ(faults.count(0), 1) << shared;
    EXPECT_EQ(faults.count(0, FaultKind::same_element), 1) << shared;
  }
}

/// Sides of elements of several faces between nodes 0 and 1, dealt to `ranks` in turn.
MeshFaults check_uses(const Model& model, const std::vector<std::pair<int, int>>& face_and_direction, int ranks) {
  const EdgeNodes edges;
  const SurfaceMesh mesh;  // without lines: no edge runs here
  MeshFaults result;
  test::run_on_ranks(ranks, [&](Ranks& own) {
    SharedLists lists;
    for (std::size_t i = 0; i < face_and_direction.size(); ++i)
      if (static_cast<int>(i) % ranks == own.rank())
        lists.sides.push_back({0, 1, -1, face_and_direction[i].first, face_and_direction[i].second, {1, 2, 3}});
    const CheckedMesh checked{model, edges, mesh, {}, {}, {}, {}, 0, std::vector<char>(model.faces.size(), 1)};
    MeshFaults faults;
    check_shared(checked, lists, own, faults);
    faults.unite(own);
    if (own.rank() == 0) result = faults;
  });
  return result;
}

TEST(CheckShared, LetsTwoElementsOfAFaceRunOpposite) {
  for (int ranks : {1, 2, 3}) {
    EXPECT_TRUE(check_uses(fake::angle(), {{1, 1}, {1, -1}}, ranks).empty());
    const MeshFaults same = check_uses(fake::angle(), {{1, 1}, {1, 1}}, ranks);
    EXPECT_EQ(same.count(1, FaultKind::side), 1);
    EXPECT_EQ(check_uses(fake::angle(), {{1, 1}}, ranks).count(1, FaultKind::side), 1);
  }
}

TEST(CheckShared, FailsTheFewestFacesThatShareASideWithoutAnEdge) {
  for (int ranks : {1, 2, 3}) {
    const MeshFaults faults = check_uses(fake::angle(), {{0, 1}, {1, 1}, {0, -1}, {1, -1}}, ranks);
    EXPECT_EQ(faults.faces(), std::vector<int>{1});
    EXPECT_EQ(faults.count(1, FaultKind::shared), 1);
    EXPECT_EQ(faults.where(1), (Vec3{1, 2, 3}));
  }
}

/// Two quads of two faces on one side of their common one: one in the plane z = 0, the other at an angle to it that
/// bends away.
MeshFaults check_pair(double angle, double bend, int order = 2) {
  const Model model = fake::angle();
  SurfaceMesh mesh;
  mesh.order = order;
  auto other = [&](double x, double t) { return Vec3{x, t * std::cos(angle), t * std::sin(angle) + bend * t * t}; };
  if (order == 1) {
    mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, other(-0.5, 2), other(1.5, 2)};
    mesh.quads = {0, 1, 2, 3, 1, 0, 4, 5};
  } else {
    mesh.nodes = {{0, 0, 0},   {1, 0, 0},   {1, 1, 0},   {0, 1, 0},    {0.5, 0, 0},
                  {1, 0.5, 0}, {0.5, 1, 0}, {0, 0.5, 0}, {0.5, 0.5, 0}};
    for (auto [x, t] : {std::pair{0.0, 2.0}, {1.0, 2.0}, {0.0, 1.0}, {0.5, 2.0}, {1.0, 1.0}, {0.5, 1.0}})
      mesh.nodes.push_back(other(x, t));
    mesh.quads = {0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 0, 9, 10, 4, 11, 12, 13, 14};
  }
  mesh.quad_face = {0, 1};
  std::vector<Region> regions(2);
  regions[1].face = 1;
  regions[0].face = 0;
  const RegionMesh own;
  const std::vector<MeshPart> parts{{&regions[0], &own, nullptr}, {&regions[1], &own, nullptr}};
  const EdgeNodes edges;
  const std::vector<PartSizes> sizes{{0, 1, 0}, {0, 1, 0}};
  const int count = static_cast<int>(mesh.nodes.size());
  const CheckedMesh checked{model, edges, mesh, parts, sizes, {}, {}, count, std::vector<char>(model.faces.size(), 1)};
  MeshFaults faults;
  SingleRank alone;
  check_sides(checked, 1, Progress(), alone, faults);
  return faults;
}

TEST(CheckSides, FindsElementsOfTwoFacesThatCoverEachOther) {
  for (int order : {1, 2}) {
    EXPECT_EQ(check_pair(0, 0, order).count(1, FaultKind::overlap), 1);
    EXPECT_EQ(check_pair(0, 0, order).count(0, FaultKind::overlap), 0);
    EXPECT_EQ(check_pair(0.001, 0, order).count(1, FaultKind::overlap), 0);
    EXPECT_EQ(check_pair(M_PI, 0, order).count(1, FaultKind::overlap), 0);
  }
  EXPECT_EQ(check_pair(0, 0.01).count(1, FaultKind::overlap), 0) << "a cylinder that touches a plane";
}

}  // namespace
}  // namespace paver
