// Parts that touch: what they share, who is on which side, what is told of it.
#include <gtest/gtest.h>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"
#include "core/brep/shape_files.h"
#include "entries/parts.h"
#include "support/fragments.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;
using test::mesh_of;
using test::model_of;
using test::report_of;

TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
  return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}

/// Upright sheet in the plane y = `y`.
TopoDS_Shape fin(double y, double x0, double x1, double z0, double z1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(0, y, 0), gp_Dir(0, 1, 0), gp_Dir(1, 0, 0))), x0, x1, -z1, -z0)
      .Shape();
}

TopoDS_Shape sheet(double z, double x0, double x1, double y0, double y1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, z), gp_Dir(0, 0, 1)), x0, x1, y0, y1).Shape();
}

TopoDS_Shape wire(gp_Pnt a, gp_Pnt b) { return BRepBuilderAPI_MakeEdge(a, b).Shape(); }

TopoDS_Shape point(gp_Pnt at) { return BRepBuilderAPI_MakeVertex(at).Shape(); }

long faces_with_area(const Model& model) {
  return std::count_if(model.faces.begin(), model.faces.end(), [](const Face& face) { return face.has_area; });
}

long junctions(const Model& model) {
  return std::count_if(model.edges.begin(), model.edges.end(),
                       [](const Edge& edge) { return edge.faces.size() > 2 && !edge.is_degenerate; });
}

long free_edges(const Model& model) {
  return std::count_if(model.edges.begin(), model.edges.end(),
                       [](const Edge& edge) { return edge.faces.size() == 1 && !edge.is_degenerate; });
}

Options with(Connect connect) {
  Options options;
  options.connect = connect;
  return options;
}

struct Case {
  const char* name;
  TopoDS_Shape shape;
  long faces, junctions, free;
  std::vector<ContactKind> contacts;
  std::size_t components;
};

std::vector<Case> cases() {
  using enum ContactKind;
  TopoDS_Shape cube = box(0, 0, 0, 50, 50, 50), plate = box(-100, -100, -10, 200, 200, 10);
  TopoDS_Shape floor = sheet(0, 0, 100, 0, 100);
  return {
      {"same face", compound({cube, box(50, 0, 0, 50, 50, 50)}), 11, 4, 0, {face}, 1},
      {"part of a face", compound({cube, box(50, 10, 15, 30, 20, 20)}), 12, 4, 0, {face}, 1},
      {"shifted", compound({cube, box(50, 25, 0, 50, 50, 50)}), 13, 4, 0, {face}, 1},
      {"edge only", compound({cube, box(50, 50, 0, 50, 50, 50)}), 12, 1, 0, {edge}, 1},
      {"corner only", compound({cube, box(50, 50, 50, 50, 50, 50)}), 12, 0, 0, {point}, 1},
      {"crossing", compound({cube, box(25, 25, 25, 50, 50, 50)}), 18, 6, 0, {crossing}, 1},
      {"one in the other", compound({cube, box(15, 15, 15, 20, 20, 20)}), 12, 0, 0, {}, 2},
      {"apart", compound({cube, box(60, 0, 0, 50, 50, 50)}), 12, 0, 0, {}, 2},
      {"rod on a plate", compound({plate, BRepPrimAPI_MakeCylinder(3, 60).Shape()}), 9, 1, 0, {face}, 1},
      {"fin on a sheet", compound({floor, fin(50, 20, 80, 0, 30)}), 2, 1, 7, {edge}, 1},
      {"fin at the rim", compound({floor, fin(50, 20, 100, 0, 30)}), 2, 1, 8, {edge}, 1},
      {"fin across", compound({floor, fin(50, 0, 100, 0, 30)}), 3, 1, 9, {edge}, 1},
      {"sheets crossing", compound({floor, fin(50, 20, 80, -30, 30)}), 3, 1, 10, {crossing}, 1},
      {"fins crossing on a sheet",
       compound(
           {floor, fin(50, 20, 80, 0, 30),
            BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(gp_Pnt(50, 0, 0), gp_Dir(1, 0, 0), gp_Dir(0, 1, 0))), 20, 80, 0, 30)
                .Shape()}),
       5,
       5,
       12,
       {edge, edge, crossing},
       1},
      {"patch on a board", compound({box(0, 0, 0, 40, 20, 3), sheet(3, 5, 15, 5, 15)}), 7, 0, 0, {face}, 1},
      {"wire on a sheet", compound({floor, wire({50, 50, 0}, {50, 50, 40})}), 1, 0, 4, {point}, 1},
      {"wire in a sheet", compound({floor, wire({20, 50, 0}, {80, 50, 0})}), 1, 0, 4, {edge}, 1},
  };
}

TEST(Connect, SharesWhatPartsHaveInCommon) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const Model model = model_of(c.shape);
    EXPECT_EQ(faces_with_area(model), c.faces);
    EXPECT_EQ(junctions(model), c.junctions);
    EXPECT_EQ(free_edges(model), c.free);
    std::vector<ContactKind> kinds;
    for (const Contact& contact : model.report.contacts) kinds.push_back(contact.kind);
    EXPECT_EQ(kinds, c.contacts);
    EXPECT_TRUE(model.report.unconnected.empty());
    for (const Face& face : model.faces) EXPECT_EQ(face.fault, "") << face.name;
  }
}

TEST(Connect, MeshesAreOnePieceWithoutCracks) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const RunReport report = report_of(c.shape, 7);
    EXPECT_EQ(report.components.size(), c.components);
    EXPECT_EQ(report.quality.inverted + report.quality.undecided, 0);
    EXPECT_NEAR(report.quality.mesh_area, report.quality.cad_area, 1e-3 * report.quality.cad_area);
    EXPECT_EQ(report.quality.nonmanifold_edges > 0, c.junctions > 0);
    EXPECT_EQ(report.quality.border_edges > 0, c.free > 0);
    for (const FaceReport& face : report.faces) EXPECT_NE(face.status, FaceStatus::failed) << face.name << face.reason;
  }
}

TEST(Connect, PartsThatTouchAreOfOneComponent) {
  auto contact = [](const char* one, const char* two) {
    Contact made;
    made.parts = {one, two};
    return made;
  };
  const std::vector<Contact> contacts{contact("Solid1", "Solid2"), contact("Solid1", "Solid3"),
                                      contact("Solid1", "Solid3"), contact("Solid2", "Sheet1")};
  using Pairs = std::vector<std::array<std::string, 2>>;
  EXPECT_EQ(contacts_apart(contacts, {{"Solid1", "Solid2", "Solid3"}}), Pairs{});  // the sheet has no mesh
  EXPECT_EQ(contacts_apart(contacts, {{"Solid1", "Solid2"}, {"Solid3"}, {"Sheet1", "Solid2"}}),
            (Pairs{{"Solid1", "Solid3"}}));
}

TopoDS_Shape copy_of(const TopoDS_Shape& shape) { return BRepBuilderAPI_Copy(shape).Shape(); }

TEST(Connect, PartsDrawnInOnePlaceHaveAllFacesInCommon) {
  const TopoDS_Shape stem = BRepPrimAPI_MakeCylinder(5, 10).Shape(), foot = box(-8, -8, -4, 16, 16, 4);
  const MeshResult once = mesh_of(compound({stem, foot}), 3),
                   thrice = mesh_of(compound({copy_of(stem), copy_of(stem), foot, copy_of(stem)}), 3);
  EXPECT_STREQ(verdict(thrice.report), "sound");
  EXPECT_NEAR(thrice.report.quality.mesh_area, once.report.quality.mesh_area, 1);
  EXPECT_EQ(once.report.model.contacts.size(), 1u);
  EXPECT_EQ(thrice.report.model.contacts.size(), 6u);  // all with all
  for (const Contact& contact : thrice.report.model.contacts) EXPECT_EQ(contact.kind, ContactKind::face);
}

TEST(Connect, TwinsArePartsWhoseFacesAllLieOnAnothers) {
  Workpiece work;
  const TopoDS_Shape stem = BRepPrimAPI_MakeCylinder(5, 10).Shape();
  std::vector<PartPair> pairs;
  for (const TopoDS_Shape& solid : {stem, box(0, 0, 0, 10, 10, 10), copy_of(stem), box(10, 0, 0, 10, 10, 10)}) {
    const int part = static_cast<int>(work.parts.size());
    for (int other = 0; other < part; ++other) pairs.push_back({other, part});
    work.parts.push_back({"", part});
    for (const TopoDS_Face& face : faces_of(solid)) {
      work.faces.emplace_back().face = face;
      work.faces.back().area = face_area(face);
      work.faces.back().uses = {{part, false}};
    }
  }
  work.diagonal = 25;
  const std::vector<Twin> twins = find_twins(work, pairs);
  ASSERT_EQ(twins.size(), 1u);  // boxes side by side have one face in common
  EXPECT_EQ(twins[0].part, 2);
  EXPECT_EQ(twins[0].of, 0);
  EXPECT_EQ(twins[0].faces.size(), 3u);
}

TEST(Connect, ACommonFaceKnowsBothSidesAndNames) {
  const Model model = model_of(compound({box(0, 0, 0, 50, 50, 50), box(50, 10, 15, 30, 20, 20)}));
  const Face& common = model.faces.back();
  EXPECT_EQ(common.name, "Face2 + Face7");  // x = 50 of the first box, of the second
  ASSERT_EQ(common.back.size(), 1u);
  ASSERT_EQ(common.front.size(), 1u);
  EXPECT_EQ(model.parts[static_cast<std::size_t>(common.back[0])], "Solid1");
  EXPECT_EQ(model.parts[static_cast<std::size_t>(common.front[0])], "Solid2");
  EXPECT_NEAR(common.area, 400, 1e-6);
  ASSERT_EQ(model.report.contacts.size(), 1u);
  EXPECT_EQ(model.report.contacts[0].faces, (std::vector<std::string>{"Face2", "Face7"}));
  EXPECT_NEAR(model.report.contacts[0].size, 400, 1e-6);
  EXPECT_EQ(model.report.contacts[0].gap, 0);
}

TEST(Connect, SidesFollowAPartThatIsInsideOut) {
  const TopoDS_Shape second = box(50, 10, 15, 30, 20, 20).Reversed();
  const Model model = model_of(compound({box(0, 0, 0, 50, 50, 50), second}));
  const Face& common = model.faces.back();
  ASSERT_EQ(common.front.size() + common.back.size(), 2u);
  EXPECT_EQ(model.parts[static_cast<std::size_t>(common.back.at(0))], "Solid1");
  EXPECT_EQ(model.parts[static_cast<std::size_t>(common.front.at(0))], "Solid2");
}

// As a fuse leaves it in FreeCAD's documents: the solid has the piece inside as a face that does not bound it.
TEST(Connect, AFaceThatAFuseHasPutIntoASolidIsASheet) {
  const TopoDS_Shape fused = test::fragments_of({box(0, 0, 0, 50, 50, 50), sheet(20, 10, 90, 10, 40)});
  const MeshResult result = mesh_of(fused, 7);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_EQ(result.report.components.size(), 1U);
  const Model model = model_of(fused);
  long inside = 0, outside = 0;
  for (const Face& face : model.faces) {
    if (std::abs(face.area - 40 * 30) < 1e-6) inside += face.front.size() == 1 && face.back.size() == 1;
    outside += face.front.empty() && face.back.empty();
  }
  EXPECT_EQ(inside, 1);
  EXPECT_EQ(outside, 1);
}

TEST(Connect, WhatLiesInsideIsKnownAndAUnionDropsIt) {
  const TopoDS_Shape crossing = compound({box(0, 0, 0, 50, 50, 50), box(25, 25, 25, 50, 50, 50)});
  const Model both = model_of(crossing);
  long inside = std::count_if(both.faces.begin(), both.faces.end(),
                              [](const Face& face) { return !face.front.empty() && !face.back.empty(); });
  EXPECT_EQ(inside, 6);
  const Model skin = model_of(crossing, with(Connect::united));
  EXPECT_EQ(faces_with_area(skin), 12);
  EXPECT_EQ(junctions(skin), 0);
  EXPECT_EQ(free_edges(skin), 0);
  const Model outer =
      model_of(compound({box(0, 0, 0, 50, 50, 50), box(15, 15, 15, 20, 20, 20)}), with(Connect::united));
  EXPECT_EQ(faces_with_area(outer), 6);
  const Model foot = model_of(compound({box(-100, -100, -10, 200, 200, 10), BRepPrimAPI_MakeCylinder(3, 60).Shape()}),
                              with(Connect::united));
  EXPECT_EQ(faces_with_area(foot), 8);
  EXPECT_EQ(junctions(foot), 0);
}

/// A solid whose shell lacks the face at the top.
TopoDS_Shape open_box(double size) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (TopExp_Explorer faces(box(0, 0, 0, size, size, size), TopAbs_FACE); faces.More(); faces.Next()) {
    Bnd_Box bounds;
    BRepBndLib::Add(faces.Current(), bounds);
    if (bounds.CornerMin().Z() < size / 2) builder.Add(shell, faces.Current());
  }
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  return solid;
}

TEST(Connect, FacesThatAUnionLeavesOpenAreNamed) {
  const Model model = model_of(compound({open_box(50), box(10, 10, 25, 30, 30, 60), box(40, 40, -10, 30, 30, 30)}),
                               with(Connect::united));
  const auto failed = std::count_if(model.faces.begin(), model.faces.end(), [](const Face& face) {
    return face.fault.find("the union leaves it open") != std::string::npos;
  });
  EXPECT_EQ(failed, 4);  // sides of the box whose bottom lies inside and whose top does not
}

TEST(Connect, NoneLeavesPartsAsDrawnAndReportsContacts) {
  const Model model = model_of(compound({box(0, 0, 0, 50, 50, 50), box(50, 0, 0, 50, 50, 50)}), with(Connect::none));
  EXPECT_EQ(model.faces.size(), 12u);
  EXPECT_EQ(junctions(model), 0);
  ASSERT_EQ(model.report.contacts.size(), 1u);
  EXPECT_EQ(model.report.contacts[0].kind, ContactKind::face);
}

bool has_node(const SurfaceMesh& mesh, Vec3 at) {
  return std::any_of(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec3 node) { return norm(node - at) < 1e-9; });
}

/// That the mesh has this one point, by its name.
void expect_point(const MeshResult& result, Vec3 at) {
  EXPECT_EQ(result.point_names, (std::vector<std::string>{"Point1"}));
  ASSERT_EQ(result.mesh.points.size(), 1u);
  EXPECT_LT(norm(result.mesh.nodes[static_cast<std::size_t>(result.mesh.points[0])] - at), 1e-9);
}

TEST(Connect, APointIsANodeInAFaceOnAnEdgeAndOnAWire) {
  for (gp_Pnt at : {gp_Pnt(41, 33, 0), gp_Pnt(41, 0, 0), gp_Pnt(100, 100, 0), gp_Pnt(50, 50, 13)}) {
    SCOPED_TRACE(at.X() + at.Z());
    const auto result = mesh_of(compound({sheet(0, 0, 100, 0, 100), wire({50, 50, 0}, {50, 50, 40}), point(at)}), 10);
    expect_point(result, {at.X(), at.Y(), at.Z()});
    EXPECT_EQ(result.report.components, (std::vector<std::vector<std::string>>{{"Sheet1", "Wire1", "Point1"}}));
    const auto& contacts = result.report.model.contacts;
    ASSERT_EQ(contacts.size(), 2u);
    EXPECT_EQ(contacts[1].kind, ContactKind::point);
    EXPECT_EQ(contacts[1].parts[1], "Point1");
    EXPECT_STREQ(verdict(result.report), "sound");
  }
}

TEST(Connect, APointOfSeveralFacesIsOneNode) {
  const auto result = mesh_of(
      compound({box(0, 0, 0, 50, 50, 50), box(50, 10, 10, 50, 50, 50), point({50, 30, 30}), point({50, 30, 30})}), 10);
  EXPECT_TRUE(has_node(result.mesh, {50, 30, 30}));
  EXPECT_EQ(result.point_names, (std::vector<std::string>{"Point1", "Point2"}));
  EXPECT_EQ(result.report.quality.border_edges, 0);
  EXPECT_EQ(result.report.components.size(), 1u);
  EXPECT_EQ(result.report.components[0].size(), 4u);
}

TEST(Connect, APointWhereAnEdgeEndsCostsNoFuse) {
  const auto result = mesh_of(compound({box(0, 0, 0, 50, 50, 50), point({50, 50, 50})}), 10);
  EXPECT_EQ(result.report.components, (std::vector<std::vector<std::string>>{{"Solid1", "Point1"}}));
  expect_point(result, {50, 50, 50});
  ASSERT_EQ(result.report.model.contacts.size(), 1u);
  EXPECT_EQ(result.report.model.contacts[0].kind, ContactKind::point);
  EXPECT_EQ(result.report.model.vertices, 8);
}

TEST(Connect, PointsAtPolesAndOnPeriodicEdgesAreNodes) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(10, 0, 20).Shape(), ball = BRepPrimAPI_MakeSphere(10).Shape();
  for (const auto& [body, at] : {std::pair{cone, gp_Pnt(0, 0, 20)}, {ball, {0, 0, 10}}, {ball, {10, 0, 0}}}) {
    SCOPED_TRACE(at.Z());
    const auto result = mesh_of(compound({body, point(at)}), 3);
    expect_point(result, {at.X(), at.Y(), at.Z()});
    EXPECT_TRUE(result.report.quality.watertight);
    EXPECT_STREQ(verdict(result.report), "sound");
    EXPECT_GT(result.report.quality.sj_all.min, 0.25);
  }
}

TEST(Connect, AWireOnTheApexOfAConeSharesItsNode) {
  const auto result = mesh_of(compound({BRepPrimAPI_MakeCone(10, 0, 20).Shape(), wire({0, 0, 20}, {0, 0, 40})}), 3);
  EXPECT_EQ(result.report.components, (std::vector<std::vector<std::string>>{{"Solid1", "Wire1"}}));
  const std::vector<int>& quads = result.mesh.quads;
  EXPECT_TRUE(std::any_of(result.mesh.lines.begin(), result.mesh.lines.end(), [&](int node) {
    return norm(result.mesh.nodes[node] - Vec3{0, 0, 20}) < 1e-9 && std::count(quads.begin(), quads.end(), node) > 0;
  }));
}

TEST(Connect, PointsFromDrawingAreLeftOut) {
  TopoDS_Compound shape = compound({box(0, 0, 0, 50, 50, 50)});
  for (int i = 0; i < 101; ++i) BRep_Builder().Add(shape, point({50, 20, 0.3 * i}));
  const auto result = mesh_of(shape, 10);
  EXPECT_EQ(result.report.notes,
            std::vector<std::string>{"101 points were left out: more than 100 are not taken for parts."});
  EXPECT_TRUE(result.report.quality.watertight);
}

TEST(Connect, APointApartIsNamedAndNoNode) {
  const auto result = mesh_of(compound({sheet(0, 0, 100, 0, 100), point({50, 50, 5})}), 10);
  EXPECT_FALSE(has_node(result.mesh, {50, 50, 5}));
  EXPECT_TRUE(result.mesh.points.empty() && result.point_names.empty());
  EXPECT_EQ(result.report.components, (std::vector<std::vector<std::string>>{{"Sheet1"}}));
  EXPECT_EQ(result.report.notes,
            std::vector<std::string>{"On no face and on no edge, so that they are no nodes: Point1."});
}

TEST(Connect, AWireIsDividedWhereItTouchesItself) {
  auto lines = [](std::vector<gp_Pnt> points) {
    BRepBuilderAPI_MakePolygon polygon;
    for (const gp_Pnt& point : points) polygon.Add(point);
    return report_of(polygon.Shape(), 1e6).quality.wire_lines;
  };
  const gp_Pnt left{-10, 0, 0}, right{10, 0, 0}, up{10, 10, 0}, over{0, 10, 0}, back{5, 0, 0}, on{15, 0, 0};
  EXPECT_EQ(lines({left, right, up, over, {0, -10, 0}}), 6) << "crosses itself";
  EXPECT_EQ(lines({left, right, up, over, {0, 0, 0}}), 5) << "ends on itself";
  EXPECT_EQ(lines({left, right, up, {5, 10, 0}, back, on}), 6) << "runs along itself";
  EXPECT_EQ(lines({left, right, up, over}), 3) << "touches nothing";
}

TEST(Connect, AWireAloneIsMeshed) {
  const RunReport report = report_of(compound({wire({0, 0, 0}, {0, 0, 60}), wire({0, 0, 60}, {40, 0, 80})}), 10);
  EXPECT_EQ(report.quality.wire_lines, 6 + 4);
  EXPECT_EQ(report.quality.quads + report.quality.triangles, 0);
}

}  // namespace
}  // namespace paver
