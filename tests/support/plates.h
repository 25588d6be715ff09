// Flat faces.
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

namespace paver::test {

inline TopoDS_Shape plate(double x0, double y0, double x1, double y1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(), x0, x1, y0, y1).Face();
}

inline TopoDS_Shape disc(double x, double y, double radius) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(x, y, 0), gp::DZ()), radius);
  return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle)));
}

}  // namespace paver::test
