// Triangles of a tessellation that lie in one plane are one face, and nothing else is.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"
#include "sizing/merging/merge_small.h"
#include "support/report_of.h"

namespace paver {
namespace {

TopoDS_Face triangle(const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c) {
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, true).Wire()).Face();
}

/// As an STL file has the shape: a shell of flat triangles.
TopoDS_Shape tessellated(const TopoDS_Shape& shape, double deflection) {
  BRepMesh_IncrementalMesh(shape, deflection, false, 0.3);
  BRepBuilderAPI_Sewing sewing(1e-6);
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    TopLoc_Location location;
    const auto mesh = BRep_Tool::Triangulation(TopoDS::Face(face.Current()), location);
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      mesh->Triangle(i).Get(a, b, c);
      if (face.Current().Orientation() == TopAbs_REVERSED) std::swap(b, c);
      sewing.Add(triangle(mesh->Node(a), mesh->Node(b), mesh->Node(c)));
    }
  }
  sewing.Perform();
  return sewing.SewedShape();
}

TopoDS_Shape block_with_hole() {
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10, 10, -1), gp_Dir(0, 0, 1)), 4, 30).Shape();
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(20, 20, 20).Shape(), hole).Shape();
}

long faces_of(const MeshResult& result, FaceStatus status) {
  return std::ranges::count_if(result.report.faces, [&](const FaceReport& face) { return face.status == status; });
}

TEST(CoplanarTriangles, ABlockIsMeshedAsOne) {
  const MeshResult result = test::mesh_of(tessellated(block_with_hole(), 0.05), 2);
  const long count = static_cast<long>(result.report.faces.size()), left = faces_of(result, FaceStatus::meshed);
  EXPECT_EQ(count - left, static_cast<long>(result.report.merges.size()));
  const long strips = left - 6;  // of the hole's wall, two triangles each
  EXPECT_EQ(count, 2 * strips + 8 + 2 * (strips + 4)) << "all of the block's faces are whole";
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_TRUE(result.report.quality.watertight);
  EXPECT_GT(result.report.quality.sj_all.min, 0.2);
  EXPECT_LT(result.report.quality.triangles, 20);
  EXPECT_NEAR(result.report.quality.mesh_area, result.report.quality.cad_area, 1e-6 * result.report.quality.cad_area);
}

TEST(CoplanarTriangles, QuadrilateralsOfABentFaceAreQuads) {
  const MeshResult result = test::mesh_of(tessellated(BRepPrimAPI_MakeTorus(10, 3).Shape(), 0.1), 2);
  EXPECT_EQ(result.report.quality.triangles, 0);
  EXPECT_EQ(2 * result.report.quality.quads, static_cast<long>(result.report.faces.size()));
  EXPECT_TRUE(std::ranges::any_of(result.report.notes, [](const std::string& note) {
    return note.find("elements are no larger than these") != std::string::npos;
  }));
}

TEST(CoplanarTriangles, WhatAUserAsksForStays) {
  const TopoDS_Shape shape = tessellated(block_with_hole(), 0.05);
  Options options;
  options.size = 2;
  options.merge = 0;
  EXPECT_EQ(faces_of(test::mesh_of(shape, options), FaceStatus::merged), 0);
  options.merge = Options().merge;
  options.local.push_back({"Face1", 0.5, 1, 1});
  EXPECT_EQ(test::mesh_of(shape, options).report.faces[0].status, FaceStatus::meshed);
}

TEST(CoplanarTriangles, LengthsAreKnownOnAllTriangles) {
  const TopoDS_Shape shape = tessellated(block_with_hole(), 0.05);
  std::vector<FacePoint> points;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    Vec3 middle;
    for (TopExp_Explorer end(face.Current(), TopAbs_VERTEX); end.More(); end.Next()) {
      const gp_Pnt x = BRep_Tool::Pnt(TopoDS::Vertex(end.Current()));
      middle += 1.0 / 6 * Vec3{x.X(), x.Y(), x.Z()};
    }
    points.push_back({static_cast<int>(points.size()), {}, middle});
  }
  Options options;
  options.size = 2;
  Progress progress;
  std::ostringstream text;
  BRepTools::Write(shape, text);
  const CadModel model = read_bytes(text.str(), "shape", progress);
  for (double length : target_lengths(model, options, points, progress)) EXPECT_NEAR(length, 2, 1e-9);
}

// Six faces each, one of which the parts have in common.
TEST(CoplanarTriangles, WhatConnectingCutIsWholeAgain) {
  const TopoDS_Shape plate = tessellated(BRepPrimAPI_MakeBox(60, 40, 2).Shape(), 1),
                     block = tessellated(BRepPrimAPI_MakeBox(gp_Pnt(5, 5, 2), 20, 10, 5).Shape(), 1);
  const MeshResult result = test::mesh_of(test::compound({plate, block}), 4);
  EXPECT_EQ(faces_of(result, FaceStatus::meshed), 12);
  EXPECT_EQ(result.report.quality.triangles, 0);
  EXPECT_EQ(result.report.components.size(), 1U);
  EXPECT_STREQ(verdict(result.report), "sound");
}

/// A block whose top is drawn as four triangles is none of triangles.
TEST(CoplanarTriangles, DrawnTrianglesStay) {
  BRepBuilderAPI_Sewing sewing(1e-6);
  const std::vector<gp_Pnt> low{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}},
      high{{0, 0, 9}, {10, 0, 9}, {10, 10, 9}, {0, 10, 9}};
  auto quad = [](const gp_Pnt& a, const gp_Pnt& b, const gp_Pnt& c, const gp_Pnt& d) {
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakePolygon(a, b, c, d, true).Wire()).Face();
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    sewing.Add(triangle(high[i], high[next], {5, 5, 9}));
    sewing.Add(quad(low[i], low[next], high[next], high[i]));
  }
  sewing.Add(quad(low[3], low[2], low[1], low[0]));
  sewing.Perform();
  const MeshResult result = test::mesh_of(sewing.SewedShape(), 3);
  EXPECT_EQ(result.report.faces.size(), 9U);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
}

}  // namespace
}  // namespace paver
