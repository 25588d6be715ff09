// What OpenCASCADE writes is sound in every version; each kind of damage that its reader follows blindly is found.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <sstream>

#include "brep/reading/texts.h"
#include "core/brep/shape_files.h"

namespace paver {
namespace {

std::string text_of(const TopoDS_Shape& shape, bool with_triangles, TopTools_FormatVersion version) {
  std::ostringstream out;
  BRepTools::Write(shape, out, with_triangles, with_triangles, version);
  return out.str();
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return at == std::string::npos ? text : text.replace(at, old.size(), by);
}

/// One triangle on each face, a side of it on each of its edges.
void add_triangles(const TopoDS_Shape& shape) {
  const BRep_Builder builder;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next()) {
    Handle(Poly_Triangulation) triangle = new Poly_Triangulation(3, 1, true);
    for (int i = 1; i <= 3; ++i) {
      triangle->SetNode(i, gp_Pnt(i, i == 2, 0));
      triangle->SetUVNode(i, gp_Pnt2d(i, i == 2));
    }
    triangle->SetTriangle(1, Poly_Triangle(1, 2, 3));
    builder.UpdateFace(TopoDS::Face(faces.Current()), triangle);
    TColStd_Array1OfInteger ends(1, 2);
    ends(1) = 1, ends(2) = 2;
    for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next())
      builder.UpdateEdge(TopoDS::Edge(edges.Current()), new Poly_PolygonOnTriangulation(ends), triangle);
  }
}

TEST(BrepText, WhatIsWrittenIsSound) {
  const TopoDS_Shape parts =
      test::compound({BRepPrimAPI_MakeBox(1, 2, 3).Shape(), BRepPrimAPI_MakeCone(2, 1, 3).Shape(),
                      BRepPrimAPI_MakeTorus(3, 1).Shape()});
  add_triangles(parts);
  for (auto version :
       {TopTools_FormatVersion_VERSION_1, TopTools_FormatVersion_VERSION_2, TopTools_FormatVersion_VERSION_3})
    for (bool with_triangles : {false, true}) EXPECT_EQ(fault_of_brep(text_of(parts, with_triangles, version)), "");
}

TEST(BrepText, NumbersThatLeadNowhereAreFound) {
  const std::string box = text_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), false, TopTools_FormatVersion_VERSION_3);
  EXPECT_EQ(fault_of_brep(box), "");
  EXPECT_NE(fault_of_brep(replaced(box, "TShapes 34", "TShapes 35")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "Curves 12", "Curves 13")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "+34 0", "+35 0")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "+34 0", "+34 1")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "1e-07", "-1")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "1e-07", "nan")), "");
  EXPECT_NE(fault_of_brep(replaced(box, "1e-07", "1e300")), "");
  EXPECT_NE(fault_of_brep(box.substr(0, box.size() / 2)), "");
}

}  // namespace
}  // namespace paver
