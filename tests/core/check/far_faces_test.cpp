// Faces that the mesh does not follow closely are named.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepFill.hxx>
#include <Geom_Parabola.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

/// Between two parabolas of this focal length up to 3 mm behind their noses, 12 mm apart, that turn at different
/// parameters: no line of the surface is a ridge. In elements of 1 mm.
RunReport ruled_nose(double focal) {
  const double end = std::sqrt(4 * focal * 3);
  const Handle(Geom_Parabola) curve = new Geom_Parabola(gp::XOY(), focal);
  Options options;
  options.size = 1;
  options.max_turn = std::numbers::pi / 2, options.aspect = 1;  // across the nose, too
  const TopoDS_Edge one = BRepBuilderAPI_MakeEdge(curve, -end, end);
  const auto above = Handle(Geom_Curve)::DownCast(curve->Translated(gp_Vec(0, 0, 12)));
  return test::mesh_of(BRepFill::Face(one, BRepBuilderAPI_MakeEdge(above, -0.8 * end, end)), options).report;
}

TEST(FarFaces, AreNamedWithTheirDistance) {
  bool is_any_far = false;
  for (double focal : {0.002, 0.01, 0.05, 0.1, 3.0}) {
    SCOPED_TRACE(focal);
    const RunReport report = ruled_nose(focal);
    EXPECT_STREQ(verdict(report), "sound");
    const bool is_far = report.faces[0].distance.largest > 0.05;
    const auto note = std::find_if(report.notes.begin(), report.notes.end(),
                                   [](const std::string& text) { return text.starts_with("Farther off"); });
    EXPECT_EQ(note != report.notes.end(), is_far) << report.faces[0].distance.largest;
    EXPECT_TRUE(!is_far || note->find("Face1 (0.") != std::string::npos);
    is_any_far = is_any_far || is_far;
  }
  EXPECT_TRUE(is_any_far);
}

}  // namespace
}  // namespace paver
