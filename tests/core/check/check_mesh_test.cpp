// Good meshes have no fault; each way of breaking one is found, with the face and a place, on one rank and on two.
#include "check/check_mesh.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/check/checked_model.h"
#include "support/thread_ranks.h"

namespace paver {
namespace {

using fake::CheckedModel;
using Break = std::function<void(CheckedModel&)>;

void expect_none(CheckedModel model) {
  const MeshFaults faults = model.check();
  for (int face : faults.faces()) ADD_FAILURE() << face << ": " << faults.reason(face);
}

TEST(CheckMesh, FindsNothingInGoodMeshes) {
  for (int order : {1, 2}) {
    for (double h : {0.4, 1.0, 2.5}) {
      SCOPED_TRACE(testing::Message() << order << " " << h);
      expect_none(CheckedModel(fake::angle(), h, order));
      expect_none(CheckedModel(fake::tube(4, 10), h, order));
      expect_none(CheckedModel(fake::ball(3), h, order));
      expect_none(CheckedModel(fake::polygon({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {1, 4, 0}}), h, order));
    }
  }
}

/// Breaks the angle's mesh in one way: one face has one kind of fault (others that come along are graver or are of that
/// face, too), at a place.
void expect_fault(int order, int face, FaultKind kind, const Break& break_it, Vec3 near, double within) {
  auto expect = [&](const MeshFaults& faults) {
    EXPECT_EQ(faults.faces(), std::vector<int>{face});
    EXPECT_GT(faults.count(face, kind), 0);
    EXPECT_LE(norm(faults.where(face) - near), within);
    EXPECT_NE(faults.reason(face).find("; "), std::string::npos);
  };
  CheckedModel whole(fake::angle(), 0.5, order);
  break_it(whole);
  expect(whole.check());
  if (order > 1 || kind == FaultKind::area) return;
  test::run_on_ranks(2, [&](Ranks& ranks) {
    CheckedModel share(fake::angle(), 0.5, order, ranks.rank(), ranks.count());
    if (share.has(face)) break_it(share);
    expect(share.check(ranks));
  });
}

constexpr Vec3 first_centre{2, 1.5, 0}, second_centre{4, 1.5, 1};

TEST(CheckMesh, FindsElementsAgainstTheNormalOfAReversedFace) {
  for (int order : {1, 2})
    expect_fault(
        order, 1, FaultKind::turned,
        [&](CheckedModel& model) {
          int* v = model.inner_quad(1);
          std::swap(v[1], v[3]);
          if (model.mesh.order == 2) std::swap(v[4], v[7]), std::swap(v[5], v[6]);
        },
        second_centre, 2);
}

TEST(CheckMesh, FindsACrackInsideAFace) {
  expect_fault(
      1, 0, FaultKind::side,
      [](CheckedModel& model) {
        int* v = model.inner_quad(0);
        std::swap(v[0], v[1]);
      },
      first_centre, 2.5);
}

TEST(CheckMesh, FindsMiddlesThatNeighboursDoNotShare) {
  expect_fault(
      2, 0, FaultKind::side,
      [](CheckedModel& model) {
        int* v = model.inner_quad(0);
        std::swap(v[4], v[8]);
      },
      first_centre, 2.5);
}

// The first node inside takes the place of one on the boundary: the sides beside that are left out.
void leave_out_of_boundary(CheckedModel& model, int face) {
  const int node = model.edges.edges[1].node[2], inner = model.inner_quad(face)[0];
  for (std::size_t i = 0; i < model.mesh.quads.size(); ++i)
    if (model.mesh.quads[i] == node && model.mesh.quad_face[i / 4] == face) model.mesh.quads[i] = inner;
}

TEST(CheckMesh, FindsABoundaryThatOneFaceDoesNotFollow) {
  for (int face : {0, 1})
    expect_fault(
        1, face, FaultKind::boundary, [&](CheckedModel& model) { leave_out_of_boundary(model, face); }, {3, 1.5, 0.5},
        2.5);
}

TEST(CheckMesh, FindsNodesOffTheirEdgeForAllItsFaces) {
  for (int order : {1, 2}) {
    CheckedModel model(fake::angle(), 0.5, order);
    const std::size_t line = static_cast<std::size_t>(
        std::find(model.mesh.line_edge.begin(), model.mesh.line_edge.end(), 1) - model.mesh.line_edge.begin());
    const std::size_t stride = static_cast<std::size_t>(order) + 1;
    const int node = model.mesh.lines[line * stride + (order == 1 ? 1 : 2)];
    model.mesh.nodes[static_cast<std::size_t>(node)] += Vec3{1e-3, 0, 1e-3};
    const MeshFaults faults = model.check();
    EXPECT_EQ(faults.faces(), (std::vector<int>{0, 1}));
    for (int face : {0, 1}) {
      EXPECT_GT(faults.count(face, FaultKind::off_edge), 0);
      EXPECT_LE(norm(faults.where(face) - Vec3{4, 0.5, 0}), 0.6);
    }
  }
}

TEST(CheckMesh, LetsMiddlesOfEdgesLieBetweenCurveAndChord) {
  CheckedModel model(fake::tube(4, 10), 2, 2);
  const Vec3 chord = 0.5 * (model.mesh.nodes[static_cast<std::size_t>(model.mesh.lines[0])] +
                            model.mesh.nodes[static_cast<std::size_t>(model.mesh.lines[1])]);
  Vec3& middle = model.mesh.nodes[static_cast<std::size_t>(model.mesh.lines[2])];
  middle = 0.5 * (middle + chord);
  EXPECT_EQ(model.check().count(0, FaultKind::off_edge), 0);
  middle = middle + 0.01 * Vec3{0, 0, 1};
  EXPECT_EQ(model.check().count(0, FaultKind::off_edge), 1);
}

TEST(CheckMesh, FindsCornersOffTheSurface) {
  expect_fault(
      1, 1, FaultKind::off_surface,
      [](CheckedModel& model) {
        model.mesh.nodes[static_cast<std::size_t>(model.inner_quad(1)[0])] += Vec3{1e-3, 0, 0};
      },
      second_centre, 2);
}

TEST(CheckMesh, FindsMiddlesAndCentresOffTheSurfaceUnlessMendingMovedThem) {
  for (std::size_t k : {4u, 5u, 8u}) {
    CheckedModel model(fake::ball(3), 1, 2);
    const int node = model.mesh.quads[9 * 20 + k];
    model.mesh.nodes[static_cast<std::size_t>(node)] = 1.01 * model.mesh.nodes[static_cast<std::size_t>(node)];
    EXPECT_EQ(model.check().count(0, FaultKind::off_surface), 1) << k;
    EXPECT_LE(norm(model.check().where(0) - model.mesh.nodes[static_cast<std::size_t>(node)]), 1e-9);
    model.moved = {node};
    EXPECT_TRUE(model.check().empty()) << k;
  }
}

TEST(CheckMesh, FindsWhatMendingMovedTooFar) {
  for (int k : {4, 8}) {
    CheckedModel model(fake::ball(3), 1, 2);
    const int node = model.inner_quad(0)[k];
    model.moved = {node};
    Vec3& x = model.mesh.nodes[static_cast<std::size_t>(node)];
    const Vec3 on = x;
    for (double off : {0.11, 0.13}) {
      x = (1 - off / 3) * on;
      EXPECT_EQ(model.check().count(0, FaultKind::chord), off > 0.12) << k;
    }
  }
}

TEST(CheckMesh, FindsStraightElementsThatCutAcrossABend) {
  // Where a size of their own is not asked for: by the turn these are too long.
  CheckedModel model(fake::ball(3), 3, 1);
  EXPECT_EQ(model.check().count(0, FaultKind::chord), 0);
  for (Region& region : model.regions) region.h = 1;
  EXPECT_GT(model.check().count(0, FaultKind::chord), 0);
}

// A quad of 45 degrees a side on a sphere of radius 3 is 0.01 off between its nodes.
TEST(CheckMesh, FindsElementsThatAreFarOffBetweenTheirNodesWhereTheSurfaceIsSteep) {
  CheckedModel model(fake::ball(3), 3, 2);
  for (Region& region : model.regions) region.h = 0.01;
  EXPECT_EQ(model.check().count(0, FaultKind::chord), 0);
  for (RegionMesh& mesh : model.paved)
    for (int v = 0; v < mesh.node_count(); ++v) mesh.xp[v] += 1.2 * norm(mesh.xp[v]) * unit(mesh.normal(v));
  EXPECT_GT(model.check().count(0, FaultKind::chord), 0);
  for (Region& region : model.regions) region.h = 3;
  EXPECT_EQ(model.check().count(0, FaultKind::chord), 0);
}

TEST(CheckMesh, FindsMiddlesFarOffTheirEdge) {
  CheckedModel model(fake::tube(4, 10), 1, 2);
  model.target_length = 1;
  for (std::size_t line = 0; line < model.mesh.line_edge.size(); ++line) {
    const int* v = &model.mesh.lines[3 * line];
    Vec3& middle = model.mesh.nodes[static_cast<std::size_t>(v[2])];
    middle =
        0.5 * (model.mesh.nodes[static_cast<std::size_t>(v[0])] + model.mesh.nodes[static_cast<std::size_t>(v[1])]);
  }
  EXPECT_EQ(model.check().count(0, FaultKind::chord), 0);  // an element's chord is 0.03 off
  model.target_length = 0.1;
  EXPECT_GT(model.check().count(0, FaultKind::chord), 0);
}

TEST(CheckMesh, FindsAFaceThatIsNotCovered) {
  for (int order : {1, 2}) {
    CheckedModel model(fake::angle(), 0.5, order);
    model.model.faces[0].area *= 1.06;
    EXPECT_EQ(model.check().count(0, FaultKind::area), 1);
    EXPECT_EQ(model.check().faces(), std::vector<int>{0});
    CheckedModel ball(fake::ball(3), 1, order);
    ball.model.faces[0].area *= order == 1 ? 1.25 : 1.08;
    EXPECT_EQ(ball.check().count(0, FaultKind::area), 1);
  }
}

TEST(CheckMesh, AFaceThatIsNotMeshedLeavesABorderToItsNeighbour) {
  CheckedModel half(fake::angle(), 0.5, 1, 0, 2);  // the first face alone
  SingleRank alone;
  EXPECT_EQ(half.check(alone).faces(), std::vector<int>{1});
  half.is_meshed[1] = 0;
  half.figures[1].status = FaceStatus::failed;
  EXPECT_TRUE(half.check(alone).empty());
}

}  // namespace
}  // namespace paver
