// Loose round faces whose periodic edge comes as two edges, as IGES has them.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepLib.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <numbers>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// The side of an upright cylinder about the z axis.
TopoDS_Shape round_face(double radius, double low, double high) {
  const Handle(Geom_CylindricalSurface) surface = new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), radius);
  const TopoDS_Vertex below = BRepBuilderAPI_MakeVertex(gp_Pnt(radius, 0, low)),
                      above = BRepBuilderAPI_MakeVertex(gp_Pnt(radius, 0, high));
  BRep_Builder builder;
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  auto add = [&](gp_Pnt2d from, gp_Dir2d way, double length, const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
    builder.Add(wire, BRepBuilderAPI_MakeEdge(new Geom2d_Line(from, way), surface, a, b, 0, length).Edge());
  };
  add({0, low}, {1, 0}, turn, below, below);
  add({turn, low}, {0, 1}, high - low, below, above);
  add({turn, high}, {-1, 0}, turn, above, above);
  add({0, high}, {0, -1}, high - low, above, below);
  TopoDS_Face face;
  builder.MakeFace(face, surface, Precision::Confusion());
  builder.Add(face, wire);
  BRepLib::BuildCurves3d(face);
  return face;
}

void add_ring(std::vector<TopoDS_Shape>& faces, double inner, double outer, double low, double high) {
  const gp_Ax2 axis(gp_Pnt(0, 0, low), gp_Dir(0, 0, 1));
  const TopoDS_Shape ring = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(axis, outer, high - low).Shape(),
                                            BRepPrimAPI_MakeCylinder(axis, inner, high - low).Shape())
                                .Shape();
  for (const TopoDS_Shape& face : test::loose_faces(ring))
    if (!Handle(Geom_Plane)::DownCast(BRep_Tool::Surface(TopoDS::Face(face))).IsNull()) faces.push_back(face);
  faces.push_back(round_face(outer, low, high));
  faces.push_back(round_face(inner, low, high));
}

// All sewn together, the periodic edges of the tube and of the rings in it became one, and the fuse lost a piece.
TEST(CloseFaces, RingsLieInTheirTube) {
  std::vector<TopoDS_Shape> faces;
  add_ring(faces, 20, 22, 0, 24);
  for (double z : {8.0, 14.0}) add_ring(faces, 15, 20, z, z + 2);
  const RunReport report = test::report_of(test::compound(faces), 6);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_TRUE(report.model.unconnected.empty());
  const double tube = turn * (42 * 24 + 22 * 22 - 20 * 20), ring = turn * (15 * 2 + 20 * 20 - 15 * 15);
  EXPECT_NEAR(report.quality.mesh_area, tube + 2 * ring, 1e-3 * tube);
}

}  // namespace
}  // namespace paver
