// Faces whose loops cross: those whose curves keep apart are divided until their facets do, the others are named and
// cost nothing more, and leave nothing behind.
#include "regions/divide_loops.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <memory>

#include "core/brep/shape_files.h"
#include "support/alone.h"
#include "support/fake_model.h"
#include "support/shares.h"

namespace paver {
namespace {

gp_Pnt at(double x, double y) { return {x, y, 0}; }

TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon maker;
  for (const gp_Pnt& corner : corners) maker.Add(corner);
  maker.Close();
  return maker.Wire();
}

TopoDS_Wire rectangle(double x, double y, double width, double height) {
  return polygon({at(x, y), at(x + width, y), at(x + width, y + height), at(x, y + height)});
}

/// Its vertex at the angle `start`.
TopoDS_Wire circle(double x, double y, double radius, double start = 0) {
  const gp_Ax2 axes(at(x, y), gp::DZ(), gp_Dir(std::cos(start), std::sin(start), 0));
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius)));
}

TopoDS_Edge arc(gp_Pnt from, gp_Pnt over, gp_Pnt to) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, over, to).Value());
}

/// In the plane z = 0, just as the wires are.
TopoDS_Face flat_face(const TopoDS_Wire& outer, const std::vector<TopoDS_Wire>& holes = {}) {
  BRepBuilderAPI_MakeFace maker(gp_Pln(), outer);
  for (const TopoDS_Wire& hole : holes) maker.Add(TopoDS::Wire(hole.Reversed()));
  return maker.Face();
}

CadModel model_of(const TopoDS_Shape& shape) {
  test::TemporaryFolder folder;
  const std::string path = folder.file("model.brep");
  BRepTools::Write(shape, path.c_str());
  Progress progress;
  return read_file(path, progress);
}

/// `own`: edges that have it as a length of their own.
Options options_of(double size, const std::vector<std::string>& own = {}) {
  Options options;
  options.size = size;
  options.threads = 1;
  for (const std::string& edge : own) options.local.push_back({edge, size});
  return options;
}

/// No node without an element or a line, no line without an element.
void expect_nothing_loose(const SurfaceMesh& mesh) {
  std::vector<char> is_used(mesh.nodes.size(), 0);
  for (const std::vector<int>* elements : {&mesh.quads, &mesh.triangles})
    for (int node : *elements) is_used[static_cast<std::size_t>(node)] = 1;
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), 0), 0);
  for (int node : mesh.lines) EXPECT_TRUE(is_used[static_cast<std::size_t>(node)]);
}

MeshResult mesh_of(const CadModel& model, double size, const std::vector<std::string>& own = {}) {
  Progress progress;
  MeshResult result = mesh_model(model, options_of(size, own), progress);
  expect_nothing_loose(result.mesh);
  return result;
}

long elements(const FaceReport& face) { return face.quads + face.triangles; }

/// The face beside a sound square far away: it is named with a point, the square is meshed as it is alone.
void expect_named(const TopoDS_Face& bad, const std::string& what, Vec3 where, double slack = 1e-6,
                  const std::vector<std::string>& own = {}) {
  const TopoDS_Face good = flat_face(rectangle(100, 0, 10, 10));
  const CadModel model = model_of(test::compound({bad, good}));
  for (double size : {20.0, 3.0, 0.7}) {
    SCOPED_TRACE(size);
    const MeshResult result = mesh_of(model, size, own);
    const FaceReport& face = result.report.faces.at(0);
    EXPECT_EQ(face.status, FaceStatus::failed);
    EXPECT_EQ(face.stage, "regions");
    EXPECT_NE(face.reason.find(what), std::string::npos) << face.reason;
    ASSERT_TRUE(face.where);
    EXPECT_LE(norm(*face.where - where), slack) << face.where->x << " " << face.where->y << " " << face.where->z;
    EXPECT_EQ(elements(result.report.faces.at(1)), elements(mesh_of(model_of(good), size).report.faces.at(0)));
    const auto error = shortfall(result);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code(), ErrorCode::face_failed);
  }
}

TEST(DivideLoops, AFigureEightIsNamed) {
  expect_named(flat_face(polygon({at(0, 0), at(12, 12), at(12, 0), at(0, 6)})), "cross or touch", {4, 4, 0});
}

TEST(DivideLoops, ALoopThatTouchesItselfIsNamed) {
  expect_named(flat_face(polygon({at(0, 0), at(10, 0), at(10, 10), at(5, 0), at(0, 10)})), "cross or touch", {5, 0, 0});
}

TEST(DivideLoops, AHoleThatCrossesTheOuterLoopIsNamed) {
  expect_named(flat_face(rectangle(0, 0, 10, 10), {circle(10, 5, 3)}), "cross or touch", {10, 5, 0}, 3.001);
}

TEST(DivideLoops, AHoleThatTouchesTheOuterLoopIsNamed) {
  expect_named(flat_face(rectangle(0, 0, 10, 10), {circle(7, 5, 3)}), "cross or touch", {10, 5, 0}, 0.01);
}

TEST(DivideLoops, HolesInOnePlaceAreNamed) {
  expect_named(flat_face(rectangle(0, 0, 10, 10), {circle(5, 5, 3), circle(5, 5, 3)}), "cross or touch", {5, 5, 0},
               3.1);
}

TEST(DivideLoops, ACurveThatCrossesItsOwnChordsNeighbourIsNamed) {
  // The arc bulges over the straight side opposite it.
  const TopoDS_Edge base = BRepBuilderAPI_MakeEdge(at(10, 0), at(10, 2)), top = arc(at(10, 2), at(5, -1), at(0, 2)),
                    left = BRepBuilderAPI_MakeEdge(at(0, 2), at(0, 0)),
                    low = BRepBuilderAPI_MakeEdge(at(0, 0), at(10, 0));
  BRepBuilderAPI_MakeWire wire(low, base, top, left);
  expect_named(flat_face(wire.Wire()), "cross or touch", {5, 0, 0}, 5);
}

TEST(DivideLoops, WhatOnlyComesNearIsDividedAsFarAsItNeeds) {
  // The hole's chords reach into the slot's round end, which lies 0.02 outside it.
  const TopoDS_Edge low = BRepBuilderAPI_MakeEdge(at(-10, -3.02), at(0, -3.02)),
                    round = arc(at(0, -3.02), at(3.02, 0), at(0, 3.02)),
                    high = BRepBuilderAPI_MakeEdge(at(0, 3.02), at(-10, 3.02)),
                    side = BRepBuilderAPI_MakeEdge(at(-10, 3.02), at(-10, -3.02));
  const CadModel model = model_of(flat_face(BRepBuilderAPI_MakeWire(low, round, high, side).Wire(), {circle(0, 0, 3)}));
  const MeshResult result = mesh_of(model, 4);
  EXPECT_FALSE(shortfall(result)) << result.report.faces[0].reason;
  EXPECT_EQ(result.report.quality.inverted, 0);
  EXPECT_LT(elements(result.report.faces[0]), 400);
  std::vector<long> lines(5, 0);
  for (int edge : result.mesh.line_edge) ++lines.at(static_cast<std::size_t>(edge));
  EXPECT_LE(*std::max_element(lines.begin(), lines.end()), 64);
  EXPECT_GE(std::count_if(lines.begin(), lines.end(), [](long n) { return n <= 4; }), 3);  // the straight sides
}

TEST(DivideLoops, ALensWhoseChordsTurnItRoundIsDivided) {
  // A strut's end that a cone cuts: the corner in the flatter side lies beyond the arc's chord.
  const gp_Pnt start = at(0, 0), corner = at(0.054, 0.0076), end = at(2, 0);
  const TopoDS_Edge round = arc(start, at(1, 0.315), end), first = BRepBuilderAPI_MakeEdge(start, corner),
                    rest = arc(corner, at(1, 0.065), end);
  const CadModel model = model_of(flat_face(BRepBuilderAPI_MakeWire(first, rest, round).Wire()));
  for (double size : {10.0, 2.0, 0.2}) {
    Options options = options_of(size);
    options.merge = 0;
    Progress progress;
    const MeshResult result = mesh_model(model, options, progress);
    EXPECT_FALSE(shortfall(result)) << size << " " << result.report.faces[0].reason;
    EXPECT_EQ(result.report.quality.inverted, 0);
  }
}

/// Intervals of a half disc's arc, whose chords a hole's tip crosses, and of the arc beyond it.
std::array<int, 2> divided_arcs(bool are_together) {
  fake::Builder builder;
  const double tip = fake::pi / 8;
  const std::vector<Vec3> at{{0, -3, 0},   {0, 3, 0},   {2.9 * std::cos(tip), 2.9 * std::sin(tip), 0},
                             {0.5, -1, 0}, {0.5, 1, 0}, {0, -5, 0},
                             {0, 5, 0}};
  for (Vec3 x : at) builder.vertex(x);
  const int round = builder.arc({}, 3, -fake::pi / 2, fake::pi / 2, 0, 1), chord = builder.line(1, 0),
            hole[] = {builder.line(2, 3), builder.line(3, 4), builder.line(4, 2)}, first = builder.line(0, 5),
            about = builder.arc({}, 5, -fake::pi / 2, fake::pi / 2, 5, 6), last = builder.line(6, 1);
  auto on_arc = [&](int edge, double radius, bool is_reversed) {
    return Coedge{edge, is_reversed, image_by([=](double t) {
                    return Vec2{radius * std::cos(t), radius * std::sin(t)};
                  })};
  };
  auto on_line = [&](int edge, int from, int to) {
    return builder.use(edge, false, {at[from].x, at[from].y}, {at[to].x, at[to].y});
  };
  const auto plane = std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0});
  builder.face(plane, 11,
               {{on_arc(round, 3, false), on_line(chord, 1, 0)},
                {on_line(hole[0], 2, 3), on_line(hole[1], 3, 4), on_line(hole[2], 4, 2)}});
  builder.face(plane, 25,
               {{on_line(first, 0, 5), on_arc(about, 5, false), on_line(last, 6, 1), on_arc(round, 3, true)}});
  const Model model = builder.take();
  EdgeCounts counts;
  counts.count.assign(model.edges.size(), 1);
  counts.count[round] = counts.count[about] = counts.count[chord] = 2;
  if (are_together) counts.together = {{round, about}};
  Progress progress;
  test::Alone alone(progress);
  const SizeField size = build_size_field(model, options_of(4), progress);
  const DividedLoops divided =
      divide_loops(model, size, plan_layouts(model, size, ClosedLayouts::made, progress), counts, false, alone);
  return {divided.nodes.edges[round].intervals(), divided.nodes.edges[about].intervals()};
}

TEST(DivideLoops, EdgesThatBelongTogetherAreDividedTogether) {
  const auto [round, about] = divided_arcs(true);
  EXPECT_GE(round, 4);
  EXPECT_EQ(about, round);
  const auto [alone, other] = divided_arcs(false);
  EXPECT_EQ(alone, round);
  EXPECT_NE(other, alone);
}

// Edges with a length of their own get no nodes that face each other.
TEST(DivideLoops, AGapThatIsTooNarrowIsNamedBeforeItCostsMuch) {
  const TopoDS_Face ring = flat_face(circle(0, 0, 3), {circle(0.1 - 1e-6, 0, 2.9, 0.3)});
  expect_named(ring, "too near", {3, 0, 0}, 0.5, {"Edge1", "Edge2"});
  for (double size : {20.0, 3.0, 0.7}) EXPECT_STREQ(verdict(mesh_of(model_of(ring), size).report), "sound") << size;
}

TEST(DivideLoops, NeighboursOfAFaceThatFailedKeepTheirCounts) {
  // Both faces have the arc; only the second has a hole that comes too near to it.
  const TopoDS_Edge common = arc(at(0, -3), at(3, 0), at(0, 3));
  const TopoDS_Edge left[] = {BRepBuilderAPI_MakeEdge(at(0, 3), at(-10, 3)),
                              BRepBuilderAPI_MakeEdge(at(-10, 3), at(-10, -3)),
                              BRepBuilderAPI_MakeEdge(at(-10, -3), at(0, -3))};
  const TopoDS_Edge right[] = {BRepBuilderAPI_MakeEdge(at(0, 3), at(10, 3)),
                               BRepBuilderAPI_MakeEdge(at(10, 3), at(10, -3)),
                               BRepBuilderAPI_MakeEdge(at(10, -3), at(0, -3))};
  BRepBuilderAPI_MakeWire one(common, left[0], left[1], left[2]), other(common, right[0], right[1], right[2]);
  const TopoDS_Face sound = flat_face(one.Wire());
  const TopoDS_Edge sliver[] = {
      arc(at(1, 2.8284271247461903 + 1e-6), at(3 + 1e-6, 0), at(1, -2.8284271247461903 - 1e-6)),
      BRepBuilderAPI_MakeEdge(at(1, -2.8284271247461903 - 1e-6), at(5, 0)),
      BRepBuilderAPI_MakeEdge(at(5, 0), at(1, 2.8284271247461903 + 1e-6))};
  BRepBuilderAPI_MakeWire hole(sliver[0], sliver[1], sliver[2]);
  const CadModel model = model_of(test::compound({sound, flat_face(other.Wire(), {hole.Wire()})}));
  const MeshResult result = mesh_of(model, 2), alone = mesh_of(model_of(sound), 2);
  ASSERT_EQ(result.report.faces.at(1).status, FaceStatus::failed);
  ASSERT_EQ(result.report.faces.at(0).status, FaceStatus::meshed) << result.report.faces[0].reason;
  EXPECT_EQ(elements(result.report.faces[0]), elements(alone.report.faces[0]));
  EXPECT_EQ(result.mesh.line_edge.size(), alone.mesh.line_edge.size());
}

TEST(DivideLoops, NothingIsLeftOfAFaceThatFailedOnAnyNumberOfRanks) {
  const TopoDS_Face bad = flat_face(polygon({at(0, 0), at(12, 12), at(12, 0), at(0, 6)}));
  const CadModel model =
      model_of(test::compound({bad, flat_face(rectangle(100, 0, 30, 10)), bad, flat_face(circle(50, 50, 20))}));
  for (int order : {1, 2}) {
    Options options = options_of(1);
    options.order = order;
    Progress progress;
    const MeshResult alone = mesh_model(model, options, progress);
    expect_nothing_loose(alone.mesh);
    for (int count : {1, 2, 3}) {
      test::expect_same_on_ranks(model, options, alone, count, 1);
      expect_nothing_loose(test::put_together(test::mesh_on_ranks(model, options, count, 1)));
    }
  }
}

}  // namespace
}  // namespace paver
