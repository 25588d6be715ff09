#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Line.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>

#include "support/report_of.h"

namespace paver {
namespace {

TopoDS_Vertex vertex(gp_Pnt at, double tolerance) {
  TopoDS_Vertex made;
  BRep_Builder().MakeVertex(made, at, tolerance);
  return made;
}

TopoDS_Edge line(gp_Pnt from, gp_Dir along, double length, const TopoDS_Vertex& start, const TopoDS_Vertex& end) {
  const Handle(Geom_Line) curve = new Geom_Line(from, along);
  return BRepBuilderAPI_MakeEdge(curve, start, end, 0, length).Edge();
}

/// A strip with a vertex in place of one of its short sides, whose tolerance holds the ends of both long ones.
TopoDS_Face strip_with_a_point(double width, double length) {
  const TopoDS_Vertex a = vertex({0, 0, 0}, 1e-7), b = vertex({width, 0, 0}, 1e-7);
  const TopoDS_Vertex top = vertex({0.5 * width, length, 0}, 0.51 * width);
  BRepBuilderAPI_MakeWire wire(line({0, 0, 0}, {1, 0, 0}, width, a, b));
  wire.Add(line({width, 0, 0}, {0, 1, 0}, length, b, top));
  wire.Add(line({0, 0, 0}, {0, 1, 0}, length, a, top));
  return BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face();
}

// Some programs join vertices of thin strips within their tolerance.
TEST(AreaSlack, HoldsWhatLiesBetweenVerticesAndTheEndsOfImages) {
  TopoDS_Compound shape;
  BRep_Builder builder;
  builder.MakeCompound(shape);
  builder.Add(shape, strip_with_a_point(0.001, 0.025));
  builder.Add(shape, BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({5, 5, 0}, {0, 0, 1})), 0, 10, 0, 10).Face());
  Options options;
  options.size = 100;
  options.merge = 0;
  const RunReport report = test::mesh_of(shape, options).report;
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.faces[0].status, FaceStatus::meshed) << report.faces[0].reason;
}

}  // namespace
}  // namespace paver
