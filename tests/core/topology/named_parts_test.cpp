// Parts keep their names in the mesh, whatever becomes of them.
#include "topology/named_parts.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <gp_Pln.hxx>
#include <set>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "core/brep/shape_files.h"
#include "entries/names.h"
#include "paver/mesher.h"
#include "support/report_of.h"

namespace paver {
namespace {

/// Two boxes on each other: Face6 of the lower one and a face of the upper one have half of each in common.
TopoDS_Shape two_boxes() {
  return test::compound(
      {BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 4, 4, 4).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(2, 0, 4), 4, 4, 4).Shape()});
}

MeshResult mesh(const TopoDS_Shape& shape, Options options, double size = 1) {
  options.size = size;
  return test::mesh_of(shape, options);
}

TEST(NamedParts, CommonFacesAreInThePortOfOneOfThem) {
  Options options;
  options.ports = {{"Gap", {"Face6"}}};
  MeshResult result = mesh(two_boxes(), options);
  std::set<std::string> names;
  for (std::size_t face = 0; face < result.face_groups.size(); ++face)
    if (result.face_groups[face] == "Gap" && result.report.faces[face].quads > 0)
      names.insert(result.report.faces[face].name);
  ASSERT_EQ(names.size(), 2u) << "what is left of the face, and what it has in common";
  EXPECT_TRUE(names.contains("Face6"));
  EXPECT_TRUE(result.report.lost_parts.empty());
}

TEST(NamedParts, VerticesOfPortsHaveANodeThere) {
  Options options;
  options.ports = {{"Pin", {"Vertex1"}}};
  MeshResult result = mesh(two_boxes(), options);
  ASSERT_EQ(result.point_names, std::vector<std::string>{"Pin"});
  const Vec3 x = result.mesh.nodes[static_cast<std::size_t>(result.mesh.points.at(0))];
  EXPECT_TRUE((x.x == 0 || x.x == 4) && (x.y == 0 || x.y == 4) && (x.z == 0 || x.z == 4));
}

// A periodic edge goes, and a smooth pole is a place like others: but for what is asked for there.
TEST(NamedParts, VerticesAtPolesAndOnPeriodicEdgesAreNodes) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 10, 0, M_PI / 2).Shape();
  const TopTools_IndexedMapOfShape vertices = shapes_of(ball, TopAbs_VERTEX);
  int pole = 0;
  for (int i = 1; i <= vertices.Extent(); ++i)
    if (BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).Z() > 9) pole = i;
  Options options;
  options.ports = {{"Pin", {"Vertex" + std::to_string(pole)}}};
  MeshResult result = mesh(ball, options, 4);
  ASSERT_EQ(result.point_names, std::vector<std::string>{"Pin"});
  EXPECT_TRUE(result.report.lost_parts.empty());
  options.ports.clear();
  options.local = {{"Vertex" + std::to_string(pole), 0.5}};
  result = mesh(ball, options, 4);
  double nearest = 1e9;
  for (Vec3 x : result.mesh.nodes)
    if (const double far = norm(x - Vec3{0, 0, 10}); far > 1e-6) nearest = std::min(nearest, far);
  EXPECT_LT(nearest, 0.4);  // the middle of a side
}

TEST(NamedParts, PiecesInAPortAndJunctionsAreEntitiesOfTheirOwn) {
  Options options;
  Model model = test::model_of(two_boxes());
  name_parts(model, options);
  const EdgeEntities plain = list_edge_entities(model);
  EXPECT_NE(std::find(plain.groups.begin(), plain.groups.end(), junctions), plain.groups.end());
  for (int e = 0; e < model.read_edges; ++e) {
    options.ports = {{"Feed", {"Edge" + std::to_string(e + 1)}}};
    name_parts(model, options);
    const EdgeEntities named = list_edge_entities(model);
    for (std::size_t k = 0; k < model.edges.size(); ++k) {
      const std::vector<int>& origins = model.edges[k].origins;
      const bool is_named = std::find(origins.begin(), origins.end(), e) != origins.end();
      EXPECT_EQ(named.groups[static_cast<std::size_t>(named.of_edge[k])] == "Feed", is_named) << e << ", " << k;
    }
  }
}

TEST(NamedParts, VolumesHaveTheirFacesSignedByTheOutwardNormal) {
  Options options;
  options.media = {{"Lower", {"Solid1"}}, {"Upper", {"Solid2"}}};
  MeshResult result = mesh(two_boxes(), options);
  ASSERT_EQ(result.volumes.size(), 2u);
  std::set<int> lower(result.volumes[0].sides.begin(), result.volumes[0].sides.end());
  int common = 0;
  for (int side : result.volumes[1].sides)
    if (lower.contains(side) || lower.contains(-side)) {
      ++common;
      EXPECT_TRUE(lower.contains(-side)) << "out of one, into the other";
    }
  EXPECT_EQ(common, 1);
  EXPECT_EQ(result.volumes[0].medium, "Lower");
  for (const FaceReport& face : result.report.faces) {
    if (face.quads == 0) continue;
    EXPECT_TRUE(face.back_medium == "Lower" || face.back_medium == "Upper") << face.name;
  }
}

/// A box, a square sheet that lies half in it and half beside it, and two wires of length 8, in it and beside it.
TopoDS_Shape box_with_insides() {
  const TopoDS_Face sheet = BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(10, 10, 5), gp_Dir(0, 0, 1)), -6, 6, -4, 4);
  return test::compound({BRepPrimAPI_MakeBox(10, 20, 10).Shape(), sheet,
                         BRepBuilderAPI_MakeEdge(gp_Pnt(3, 2, 3), gp_Pnt(3, 10, 3)).Shape(),
                         BRepBuilderAPI_MakeEdge(gp_Pnt(-3, 2, 3), gp_Pnt(-3, 10, 3)).Shape()});
}

TEST(NamedParts, WhatLiesInsideASolidHasTheWavelengthInItsMedium) {
  Options options;
  options.frequency = 7.5e9;  // 40 mm
  options.divisions = 10;
  options.media = {{"Dense", {"Solid1"}, 16.0}};
  for (const Connect connect : {Connect::imprint, Connect::none}) {
    SCOPED_TRACE(connect == Connect::none ? "not connected" : "connected");
    options.connect = connect;
    const MeshResult result = test::mesh_of(box_with_insides(), options);
    const FaceReport& sheet = result.report.faces[6];
    EXPECT_NEAR(*sheet.wavelength, 10, 0.01);
    if (connect == Connect::none) continue;
    EXPECT_TRUE(sheet.front.empty() && sheet.back.empty()) << "as not all of it lies inside";
    EXPECT_EQ(sheet.front_medium, std::nullopt);
    EXPECT_GT(sheet.quads, 48) << "of 1 mm on 48 mm2";
    EXPECT_LT(sheet.quads, 96);
    EXPECT_EQ(result.report.quality.wire_lines, 8 + 2);
    EXPECT_EQ(result.report.faces[0].back, std::vector<std::string>{"Solid1"});
  }
}

TEST(NamedParts, WhatAUnionLeavesOutIsAFault) {
  Options options;
  options.connect = Connect::united;
  options.ports = {{"Gap", {"Face6"}}, {"Side", {"Face1"}}};
  const TopoDS_Shape boxes = test::compound(
      {BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 4, 4, 4).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 4), 4, 4, 4).Shape()});
  MeshResult result = mesh(boxes, options);
  EXPECT_EQ(result.report.lost_parts, std::vector<std::string>{"Face6 of 'Gap'"});
  EXPECT_STREQ(verdict(result.report), "faulty");
  EXPECT_TRUE(shortfall(result));
}

TEST(NamedParts, VerticesThatAUnionLeavesOutAreAFaultThoughOthersOfThePortStay) {
  Options options;
  options.connect = Connect::united;
  // The second box lies within the first.
  const TopoDS_Shape boxes = test::compound(
      {BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 8, 8, 8).Shape(), BRepPrimAPI_MakeBox(gp_Pnt(2, 2, 2), 4, 4, 4).Shape()});
  options.ports = {{"Pins", {"Vertex1", "Vertex9"}}};
  const MeshResult result = mesh(boxes, options, 2);
  EXPECT_EQ(result.point_names, std::vector<std::string>{"Pins"});
  EXPECT_EQ(result.report.lost_parts, std::vector<std::string>{"Vertex9 of 'Pins'"});
}

TEST(NamedParts, RefusesPartsThatAreNotThere) {
  Options options;
  options.media = {{"FR4", {"Solid3"}}};
  EXPECT_THROW(mesh(two_boxes(), options), Error);
}

}  // namespace
}  // namespace paver
