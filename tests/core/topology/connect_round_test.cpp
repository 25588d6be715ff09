// Parts that touch faces that go round, on their periodic edge and beside it; which way sheets face; what hangs
// together is looked for in the mesh itself.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <gp_Circ.hxx>
#include <gp_GTrsf.hxx>
#include <gp_Pln.hxx>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "base/union_find.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"
#include "support/fragments.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::loose_faces;
using test::mesh_of;

template <class F>
void for_rows(const SurfaceMesh& mesh, F&& f) {
  for (std::size_t i = 0; i < mesh.quad_count(); ++i)
    f(&mesh.quads[i * static_cast<std::size_t>(mesh.nodes_per_quad())], 4);
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i)
    f(&mesh.triangles[i * static_cast<std::size_t>(mesh.nodes_per_triangle())], 3);
}

/// Meshes that share no node, lines included.
std::size_t pieces(const SurfaceMesh& mesh) {
  UnionFind together(mesh.nodes.size());
  std::set<int> used;
  auto add = [&](const int* row, int corners) {
    for (int k = 0; k < corners; ++k) together.merge(row[0], row[k]), used.insert(row[k]);
  };
  for_rows(mesh, add);
  const auto step = static_cast<std::size_t>(mesh.order + 1);
  for (std::size_t i = 0; i < mesh.lines.size(); i += step) add(&mesh.lines[i], 2);
  std::set<int> roots;
  for (int node : used) roots.insert(together.find(node));
  return roots.size();
}

/// Sides of two elements that both run through it the same way.
int same_way(const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, std::vector<bool>> sides;
  for_rows(mesh, [&](const int* row, int corners) {
    for (int k = 0; k < corners; ++k) {
      const int a = row[k], b = row[(k + 1) % corners];
      sides[std::minmax(a, b)].push_back(a < b);
    }
  });
  return static_cast<int>(std::count_if(sides.begin(), sides.end(), [](const auto& side) {
    return side.second.size() == 2 && side.second[0] == side.second[1];
  }));
}

/// Its periodic edge is the line y = 0, x > 0 of its own place.
TopoDS_Shape rod(double x, double y, double z, double radius, double height) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)), radius, height).Shape();
}

TopoDS_Shape sheet(double z, double x0, double x1, double y0, double y1, bool is_up = true) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), x0, x1, y0, y1)
      .Shape()
      .Oriented(is_up ? TopAbs_FORWARD : TopAbs_REVERSED);
}

/// In the plane y = 0.
TopoDS_Shape fin(double x0, double x1, double z0, double z1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 1, 0), gp_Dir(1, 0, 0))), x0, x1, -z1, -z0)
      .Shape();
}

TopoDS_Shape wire(gp_Pnt a, gp_Pnt b) { return BRepBuilderAPI_MakeEdge(a, b).Shape(); }

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

void expect_one_piece(const char* name, const TopoDS_Shape& shape) {
  SCOPED_TRACE(name);
  const MeshResult result = mesh_of(shape, 4);
  for (const FaceReport& face : result.report.faces)
    EXPECT_NE(face.status, FaceStatus::failed) << face.name << ": " << face.reason;
  EXPECT_TRUE(result.report.model.unconnected.empty());
  EXPECT_EQ(result.report.components.size(), 1u);
  EXPECT_EQ(pieces(result.mesh), 1u);
  EXPECT_EQ(same_way(result.mesh), 0);
  EXPECT_NEAR(result.report.quality.mesh_area, result.report.quality.cad_area, 2e-3 * result.report.quality.cad_area);
}

// Cut out of one ball they share vertices, edges and its surface.
TEST(ConnectRound, OctantsThatMeetAtThePeriodicEdgeOfTheirBall) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(30).Shape();
  auto octant = [&](double y) {
    return BRepAlgoAPI_Common(ball, BRepPrimAPI_MakeBox(gp_Pnt(0, std::min(0.0, y), 0), 40, std::abs(y), 40).Shape())
        .Shape();
  };
  const RunReport report = test::report_of(compound({octant(40), octant(-40)}), 5);
  EXPECT_STREQ(verdict(report), "sound");
  // Three quarter discs each, of which one is common, and two eighths of the ball.
  const double area = std::numbers::pi * 900 * (5 * 0.25 + 1);
  EXPECT_NEAR(report.quality.mesh_area, area, 1e-4 * area);
  EXPECT_EQ(report.components.size(), 1U);
}

TEST(ConnectRound, APeriodicEdgeKeepsTheNodesThatOthersNeed) {
  expect_one_piece("rods side by side", compound({rod(0, 0, 0, 10, 20), rod(15, 0, 0, 5, 20)}));
  expect_one_piece("the other one's edge", compound({rod(0, 0, 0, 10, 20), rod(-15, 0, 0, 5, 20)}));
  expect_one_piece("over a part of the edge", compound({rod(0, 0, 0, 10, 30), rod(15, 0, 10, 5, 10)}));
  expect_one_piece("a rod in a rod", compound({rod(0, 0, 0, 10, 20), rod(5, 0, 0, 5, 20)}));
  expect_one_piece("fin along the edge", compound({rod(0, 0, 0, 10, 20), fin(10, 20, 0, 20)}));
  expect_one_piece("fin on a part of it", compound({rod(0, 0, 0, 10, 30), fin(10, 20, 8, 16)}));
  expect_one_piece("fin off the edge", compound({rod(0, 0, 0, 10, 30), fin(-20, -10, 8, 16)}));
  expect_one_piece("wire on the edge", compound({rod(0, 0, 0, 10, 30), wire({10, 0, 5}, {10, 0, 21})}));
}

TEST(ConnectRound, AVertexOnAPeriodicEdgeIsANodeWhereOthersHaveIt) {
  expect_one_piece("wire to the edge", compound({rod(0, 0, 0, 10, 30), wire({10, 0, 12}, {25, 0, 12})}));
  expect_one_piece("wire off the edge", compound({rod(0, 0, 0, 10, 30), wire({-10, 0, 12}, {-25, 0, 12})}));
  expect_one_piece("wire to a sphere", compound({BRepPrimAPI_MakeSphere(10).Shape(), wire({10, 0, 0}, {25, 0, 0})}));
}

TEST(ConnectRound, SlitsShorterThanAnElementAreLoops) {
  expect_one_piece("inside a sheet", compound({sheet(0, -20, 20, -20, 20), fin(-1, 1, 0, 5)}));
  expect_one_piece("from the periodic edge", compound({rod(0, 0, 0, 10, 30), sheet(12, 0, 30, 0, 2.6)}));
  expect_one_piece("on both sides of it", compound({rod(0, 0, 0, 10, 30), sheet(12, 0, 30, -2.6, 2.6)}));
}

TEST(ConnectRound, APieceOfAFaceThatGoesRoundHasNoCrease) {
  const MeshResult result = mesh_of(compound({rod(0, 0, 0, 10, 20), fin(-20, 20, 0, 20)}), 4);
  for (const std::string& note : result.report.notes) EXPECT_EQ(note.find("crease"), std::string::npos) << note;
  expect_one_piece("fin through a rod", compound({rod(0, 0, 0, 10, 20), fin(-20, 20, 0, 20)}));
}

// A conformal antenna: part of the skin's own surface, which the kernel's intersection of splines would not end with.
TEST(ConnectRound, APatchCutOutOfAFreeFormSkinIsCommon) {
  TColgp_Array2OfPnt poles(1, 5, 1, 5);
  for (int i = 1; i <= 5; ++i)
    for (int j = 1; j <= 5; ++j) poles(i, j) = gp_Pnt(10 * i, 10 * j, 3 * std::sin(1.7 * i) * std::cos(1.3 * j));
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  auto piece = [&](double u0, double u1, double v0, double v1) {
    return BRepBuilderAPI_MakeFace(surface, u0, u1, v0, v1, 1e-7).Shape();
  };
  expect_one_piece("patch inside", compound({piece(0, 1, 0, 1), piece(0.3, 0.6, 0.2, 0.5)}));
  expect_one_piece("patch to the rim", compound({piece(0, 1, 0, 1), piece(0, 0.4, 0.2, 0.5)}));
}

TEST(ConnectRound, SheetsThatMeetFaceTheSameWay) {
  expect_one_piece("side by side", compound({sheet(0, 0, 20, 0, 20), sheet(0, 20, 40, 5, 30, false)}));
  expect_one_piece("overlapping", compound({sheet(0, 0, 20, 0, 20), sheet(0, 10, 30, 5, 30, false)}));
}

TEST(ConnectRound, SheetsSewnAtAnEdgeAreConnectedWhereTheyOverlapToo) {
  expect_one_piece("one over the other", compound({sheet(0, 0, 20, 0, 20), sheet(0, 0, 20, 0, 10)}));
  expect_one_piece("the other way up", compound({sheet(0, 0, 20, 0, 20), sheet(0, 0, 20, 0, 10, false)}));
}

TEST(ConnectRound, WhatASolidAndASheetHaveInCommonFacesOutOfTheSolid) {
  for (bool is_up : {true, false})
    for (bool is_first : {true, false}) {
      const TopoDS_Shape patch = sheet(0, 5, 35, 5, 15, is_up), block = box(0, 0, -10, 20, 20, 10);
      expect_one_piece("patch over a rim", is_first ? compound({patch, block}) : compound({block, patch}));
    }
}

TEST(ConnectRound, AWireEndsOnWhatSeveralFacesHaveInCommon) {
  expect_one_piece("wire on a patch on a box",
                   compound({box(0, 0, -10, 20, 20, 10), sheet(0, 4, 16, 4, 16), wire({10, 10, 0}, {10, 10, 30})}));
}

TEST(ConnectRound, WiresMayEndNearEachOtherAndNearAnEdge) {
  expect_one_piece("three wires", compound({sheet(0, 0, 40, 0, 40), wire({20, 20, 0}, {20, 20, 30}),
                                            wire({20.5, 20, 0}, {20.5, 20, 30}), wire({20, 0.3, 0}, {20, 0.3, 30})}));
}

// Four quads are laid about the end of the wire in advance: they must not reach round the rod.
TEST(ConnectRound, AWireEndsOnARodThinnerThanTheTargetLength) {
  for (double size : {4.0, 10.0, 1e6}) {
    const MeshResult result =
        mesh_of(compound({rod(0, 0, 0, 0.5, 40), wire(gp_Pnt(0, 0.5, 20), gp_Pnt(0, 10, 20))}), size);
    EXPECT_STREQ(verdict(result.report), "sound") << size;
    EXPECT_EQ(pieces(result.mesh), 1U) << size;
  }
}

/// Of revolution about the z axis, free-form along the meridian.
TopoDS_Shape dish(double radius, double depth) {
  TColgp_Array1OfPnt poles(1, 3);
  poles(1) = gp_Pnt(0, 0, 0), poles(2) = gp_Pnt(radius / 2, 0, 0), poles(3) = gp_Pnt(radius, 0, depth);
  const TopoDS_Shape meridian = BRepBuilderAPI_MakeEdge(Handle(Geom_Curve)(new Geom_BezierCurve(poles))).Shape();
  return BRepPrimAPI_MakeRevol(meridian, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape();
}

TEST(ConnectRound, AWireEndsAtAPole) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  for (double size : {1e6, 10.0, 3.5, 1.0})
    for (const auto& [body, z] : {std::pair{dish(20, 5), 0.0}, std::pair{ball, 10.0}}) {
      const MeshResult result = mesh_of(compound({body, wire(gp_Pnt(0, 0, z), gp_Pnt(0, 0, z + 8))}), size);
      EXPECT_STREQ(verdict(result.report), "sound") << size << " " << z;
      EXPECT_EQ(pieces(result.mesh), 1U) << size << " " << z;
      EXPECT_GT(result.report.quality.sj_all.min, 0.3) << size << " " << z;
    }
}

// One of its two periodic edges stays as a cut: a point on that is a node of it.
TEST(ConnectRound, AWireEndsOnEachPeriodicEdgeOfATorus) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(20, 5).Shape();
  for (double size : {10.0, 3.0})
    for (const auto& [a, b] :
         {std::pair{gp_Pnt(25 * std::cos(1), 25 * std::sin(1), 0), gp_Pnt(35 * std::cos(1), 35 * std::sin(1), 0)},
          {gp_Pnt(20, 0, 5), gp_Pnt(20, 0, 15)},
          {gp_Pnt(25, 0, 0), gp_Pnt(35, 0, 0)}}) {
      const MeshResult result = mesh_of(compound({torus, wire(a, b)}), size);
      EXPECT_STREQ(verdict(result.report), "sound") << size << " " << a.X();
      EXPECT_EQ(pieces(result.mesh), 1U) << size << " " << a.X();
    }
}

// The kernel puts the point into one of the faces, and on the periodic edge of the other one.
TEST(ConnectRound, RoundPartsThatTouchInAPointShareANodeThere) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0, 0, 10), 10).Shape();
  for (const TopoDS_Shape& other : {box(-20, -20, -5, 40, 40, 5), BRepPrimAPI_MakeSphere(gp_Pnt(16, 0, 10), 6).Shape()})
    for (double size : {11.0, 4.0}) {
      const MeshResult result = mesh_of(compound({ball, other}), size);
      EXPECT_STREQ(verdict(result.report), "sound") << size;
      EXPECT_EQ(pieces(result.mesh), 1U) << size;
    }
}

// The tolerance that is asked for holds between parts, too.
TEST(ConnectRound, ABoardThinnerThanTheToleranceKeepsBothItsFaces) {
  Options options;
  options.size = 10;
  options.sew_tolerance = 5;
  const MeshResult result =
      mesh_of(compound({box(0, 0, 0, 40, 40, 1.6), sheet(1.6, 10, 30, 0, 20), sheet(0, 5, 35, 20, 40)}), options);
  EXPECT_NEAR(result.report.quality.mesh_area, 2 * 1600 + 160 * 1.6, 5);
}

// There the kernel finds a part of where they cross, or none.
TEST(ConnectRound, PartsFarFromTheOriginAreConnectedLikeThoseAtIt) {
  const TopoDS_Shape parts = compound({rod(0, 0, 0, 10, 80), box(5, -1, -10, 20, 2, 40)});
  const MeshResult here = mesh_of(parts, 4);
  for (double away : {3e4, 1e5, 3e6}) {
    gp_Trsf shift;
    shift.SetTranslation(gp_Vec(0.6 * away, -0.7 * away, 0.4 * away));
    const MeshResult there = mesh_of(BRepBuilderAPI_Transform(parts, shift, true).Shape(), 4);
    EXPECT_STREQ(verdict(there.report), "sound") << away;
    EXPECT_EQ(pieces(there.mesh), 1U) << away;
    EXPECT_NEAR(there.report.quality.mesh_area, here.report.quality.mesh_area, 1) << away;
    EXPECT_EQ(there.report.model.contacts.size(), here.report.model.contacts.size()) << away;
    EXPECT_NEAR(there.mesh.nodes[0].x, 0.6 * away, 100) << away;
  }
}

// Where two bodies touch, more than two of their edges lie on one another.
TEST(ConnectRound, BodiesOfLooseFacesAreConnectedLikeSolids) {
  const TopoDS_Shape lower = box(0, 0, 0, 20, 20, 20);
  for (const TopoDS_Shape& upper :
       {box(5, 5, 20, 10, 10, 10), box(10, 0, 20, 20, 20, 20), box(20, 0, 20, 20, 20, 20)}) {
    const MeshResult solids = mesh_of(compound({lower, upper}), 4);
    for (const TopoDS_Shape& parts : {compound({lower, upper}), compound({upper, lower})})
      for (bool is_backwards : {false, true}) {
        std::vector<TopoDS_Shape> faces = loose_faces(parts);
        if (is_backwards) std::reverse(faces.begin(), faces.end());
        const MeshResult loose = mesh_of(compound(faces), 4);
        EXPECT_STREQ(verdict(loose.report), "sound");
        EXPECT_NEAR(loose.report.quality.mesh_area, solids.report.quality.mesh_area, 1e-6);
        EXPECT_EQ(loose.report.quality.nonmanifold_edges, solids.report.quality.nonmanifold_edges);
        EXPECT_EQ(loose.report.quality.border_edges, 0);
      }
  }
}

// A pin in the holes of two plates: sewn with theirs, its edges made the kernel lose a hole's wall.
TEST(ConnectRound, BodiesThatComeAsCompoundsOfFacesAreSewnEachByItself) {
  const TopoDS_Shape pin = rod(0, 0, 0, 2, 4);
  const std::vector<TopoDS_Shape> bodies = {BRepAlgoAPI_Cut(box(-9, -9, 0, 18, 18, 2), pin).Shape(),
                                            BRepAlgoAPI_Cut(box(-5, -9, 2, 18, 18, 2), pin).Shape(), pin};
  std::vector<TopoDS_Shape> loose;
  for (const TopoDS_Shape& body : bodies) loose.push_back(compound(loose_faces(body)));
  const MeshResult solids = mesh_of(compound(bodies), 2);
  const MeshResult result = mesh_of(compound({compound({loose[0], loose[1]}), loose[2]}), 2);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_NEAR(result.report.quality.mesh_area, solids.report.quality.mesh_area, 1e-3);
  EXPECT_EQ(result.report.quality.border_edges, 0);
  EXPECT_EQ(result.report.model.contacts.size(), 3u);
}

// In the order in which the parts are given the kernel loses half of the ball.
TEST(ConnectRound, ABallWhoseParametersAreNegativeLiesInItsSocket) {
  const TopoDS_Shape socket = BRepAlgoAPI_Cut(box(-25, -25, -30, 50, 50, 30), BRepPrimAPI_MakeSphere(18)).Shape();
  const Handle(Geom_Surface) round = new Geom_SphericalSurface(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, -1)), 18);
  const double pi = std::numbers::pi;
  const TopoDS_Shape ball = BRepBuilderAPI_MakeFace(round, -2 * pi, 0, -pi / 2, pi / 2, 1e-7).Shape();
  const MeshResult result = mesh_of(compound({socket, ball}), 4);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_NEAR(result.report.quality.mesh_area, 4 * 1500 + 5000 - pi * 18 * 18 + 4 * pi * 18 * 18, 5);
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, double factor) {
  gp_Trsf scale;
  scale.SetScaleFactor(factor);
  return BRepBuilderAPI_Transform(shape, scale).Shape();
}

/// A box, a cone that stands on it tilted a little, and a rod in both.
TopoDS_Compound tilted_foot(double tilt, const TopoDS_Shape& other) {
  const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(tilt, 0, 1));
  return compound({box(-90, -90, -50, 180, 180, 50), BRepPrimAPI_MakeCone(axis, 8, 3, 10).Shape(), other});
}

// The kernel follows intersections in steps of a fixed length, and takes for one what is as near.
TEST(ConnectRound, PartsAreConnectedAlikeAtAnySize) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(9, 1, 2), 8).Shape(),
                     horn = BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(0, -10, -12), gp_Dir(.1, .3, 1)), 6, 1, 30).Shape();
  const gp_Ax2 axis(gp_Pnt(11.3926, 1.1217, 0), gp_Dir(1.745e-4, 0, 1));
  const TopoDS_Compound foot = tilted_foot(5.236e-3, BRepPrimAPI_MakeCylinder(axis, 6, 4).Shape());
  for (const TopoDS_Shape& parts : {compound({ball, horn}), foot}) {
    const MeshResult plain = mesh_of(parts, 4);
    for (const double factor : {1e6, 1e-3}) {
      SCOPED_TRACE(factor);
      const MeshResult other = mesh_of(scaled(parts, factor), 4 * factor);
      EXPECT_TRUE(other.report.model.unconnected.empty());
      ASSERT_EQ(other.report.model.contacts.size(), plain.report.model.contacts.size());
      const Contact &there = other.report.model.contacts[0], &here = plain.report.model.contacts[0];
      EXPECT_NEAR(there.size, factor * here.size, 1e-5 * factor * here.size);
      EXPECT_STREQ(verdict(other.report), verdict(plain.report));
      EXPECT_NEAR(other.report.quality.mesh_area, factor * factor * plain.report.quality.mesh_area,
                  1e-3 * other.report.quality.mesh_area);
    }
  }
}

TEST(ConnectRound, WhatCannotBeConnectedKeepsItsSize) {
  constexpr double factor = 1e-5;  // the kernel fails
  const MeshResult result = mesh_of(scaled(tilted_foot(5.06e-3, rod(11.4, 1.1, -.2, 6, 4)), factor), 8 * factor);
  EXPECT_FALSE(result.report.model.unconnected.empty());
  for (const Vec3 x : result.mesh.nodes) EXPECT_LT(norm(x), 200 * factor);
}

/// Half a tube about z, 12 high, whose parameters run on past its surface's period; a wire ends on it at `angle`.
TopoDS_Shape tube_with_wire(double angle) {
  const gp_Circ circle(gp_Ax2(), 5);
  const TopoDS_Shape arc = BRepBuilderAPI_MakeEdge(circle, 1.5 * M_PI, 2.5 * M_PI).Shape();
  const gp_XYZ out(std::cos(angle), std::sin(angle), 0), up(0, 0, 6);
  const TopoDS_Shape wire = BRepBuilderAPI_MakeEdge(gp_Pnt(5 * out + up), gp_Pnt(10 * out + up)).Shape();
  return test::compound({BRepPrimAPI_MakePrism(arc, gp_Vec(0, 0, 12)).Shape(), wire});
}

TEST(ConnectRound, AWireMeetsAFaceOnEitherSideOfItsPeriod) {
  for (double angle : {-0.5, 0.5}) {
    const RunReport report = test::report_of(tube_with_wire(angle), 1.2);
    EXPECT_STREQ(verdict(report), "sound") << angle;
    EXPECT_EQ(report.components.size(), 1U);
  }
}

void expect_one_piece(const TopoDS_Shape& shape, double size) {
  SCOPED_TRACE(size);
  const MeshResult result = mesh_of(shape, size);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_EQ(pieces(result.mesh), 1U);
  ASSERT_EQ(result.report.model.contacts.size(), 1U);
  EXPECT_EQ(result.report.model.contacts[0].kind, ContactKind::point);
}

TEST(ConnectRound, ABallLiesOnAPlateWhateverItsAxis) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -4), 40, 40, 4).Shape();
  for (const gp_Dir& axis : {gp_Dir(0, 0, 1), gp_Dir(1, 0, 0), gp_Dir(1, 2, 3), gp_Dir(-0.3, 0.8, 0.1)}) {
    gp_Trsf turn;  // after it was made: by rounding it lies a little above or below
    turn.SetRotation(gp_Ax1({1.3, 2.7, 5}, gp_Dir(0.2, -0.5, 0.7)), 1.1);
    const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2({1.3, 2.7, 5}, axis), 5).Shape();
    for (const double size : {1.5, 3.8, 1e6})
      expect_one_piece(compound({plate, BRepBuilderAPI_Transform(ball, turn).Shape()}), size);
  }
}

// As FreeCAD's documents have them: the pole is a vertex inside the plate's face, too.
TEST(ConnectRound, ABallLiesOnAPlateAfterAFuse) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -4), 40, 40, 4).Shape();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(1.3, 2.7, 5), 5).Shape();
  expect_one_piece(BRepAlgoAPI_Fuse(plate, ball).Shape(), 2.5);
}

TEST(ConnectRound, ASplineLiesOnAPlate) {
  gp_GTrsf stretch;
  stretch.SetVectorialPart({3, 0, 0, 0, 2, 0, 0, 0, 1.5});
  const TopoDS_Shape egg =
      BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 2}, {1, 2, 3}), 2).Shape(), stretch).Shape();
  expect_one_piece(compound({BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -4), 40, 40, 4).Shape(), egg}), 2);
}

TEST(ConnectRound, ARodEndsOnABall) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  for (const double beside : {0.0, 0.4}) {
    const gp_Ax2 out({-10, beside, 0.75 * beside}, {-1, 0, 0});
    expect_one_piece(compound({ball, BRepPrimAPI_MakeCylinder(out, 1, 15).Shape()}), 3);
  }
}

TopoDS_Shape ball_at(gp_Pnt centre) { return BRepPrimAPI_MakeSphere(centre, 10).Shape(); }

TEST(ConnectRound, ABallMayHaveAPoleOnACylinder) {
  const TopoDS_Shape tube = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -10}, {0, 0, 1}), 10, 20).Shape();
  for (const gp_Pnt& centre : {gp_Pnt(0, -10, 10), gp_Pnt(-10, 0, -5), gp_Pnt(8, 6, 4)}) {
    const RunReport report = test::report_of(compound({tube, ball_at(centre)}), 2);
    EXPECT_STREQ(verdict(report), "sound");
    EXPECT_LT(report.quality.triangles, 10);
    EXPECT_GT(report.quality.sj_all.min, 0.2);
    EXPECT_EQ(report.components.size(), 1U);
  }
}

TEST(ConnectRound, PlacesOnABallStayWhereItsAxisIsTurned) {
  const TopoDS_Shape tube = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, -10}, {0, 0, 1}), 10, 20).Shape();
  const gp_Pnt centre(0, -10, 10);
  const Model model = test::model_of(compound({tube, ball_at(centre)}));
  const Geom_SphericalSurface as_read(gp_Ax3(centre, gp::DZ()), 10);
  int turned = 0;
  for (const Face& face : model.faces) {
    if (!face.converted || !face.has_area) continue;
    ++turned;
    for (const Vec2 uv : {Vec2{0.3, 0.4}, Vec2{2, -1}, Vec2{5, 1.2}}) {
      const gp_Pnt at = as_read.Value(uv.x, uv.y);
      EXPECT_LT(norm(face.surface->point(face.converted(uv)) - Vec3{at.X(), at.Y(), at.Z()}), 1e-9);
    }
  }
  EXPECT_GT(turned, 0);
}

// STEP files walk the periodic edges of tori along these first.
TEST(ConnectRound, ABentConductorLiesInItsInsulator) {
  auto bend = [](double radius) { return BRepPrimAPI_MakeTorus(8, radius, -M_PI, M_PI, M_PI_2).Shape(); };
  const test::TemporaryFolder folder;
  const std::string path = folder.file("bend.step");
  test::write_step(compound({BRepAlgoAPI_Cut(bend(2.5), bend(1)).Shape(), bend(1)}), path);
  Options options;
  options.size = 1;
  Progress progress;
  const RunReport report = mesh_file(path, options, progress).report;
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.components.size(), 1U);
  EXPECT_EQ(report.quality.border_edges, 0U);
}

// The line in which they touch is an edge inside the rod's wall, and divides the top of the box.
TEST(ConnectRound, ARodOnABoxThatWereFusedBeforeIsConnected) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, -1.5, -3), 40, 3, 3).Shape();
  const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, -10, 0.5), gp::DY()), 0.5, 20).Shape();
  for (double size : {100.0, 3.0}) {
    const MeshResult result = mesh_of(test::fragments_of({box, bar}), size);
    EXPECT_STREQ(verdict(result.report), "sound") << size;
    EXPECT_EQ(result.report.quality.border_edges, 0);
    EXPECT_EQ(pieces(result.mesh), 1U);
  }
}

// The same on a sheet, by itself and together with a box that the rod runs into.
TEST(ConnectRound, ARodOnASheetThatWereFusedBeforeIsConnected) {
  const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(gp_Pln(), -20, 110, -30, 70).Face();
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, -4, 6), gp::DY()), 6, 8).Shape();
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 5), 85, 36, 20).Shape();
  for (const bool has_box : {false, true}) {
    const MeshResult result =
        mesh_of(test::fragments_of(has_box ? std::vector{rod, sheet, box} : std::vector{rod, sheet}), 5);
    EXPECT_STREQ(verdict(result.report), "sound") << has_box;
    EXPECT_EQ(pieces(result.mesh), 1U) << has_box;
  }
}

}  // namespace
}  // namespace paver
