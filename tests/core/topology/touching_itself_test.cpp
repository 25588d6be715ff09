// Solids that touch themselves where a program has written edges and faces twice.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Solid.hxx>

#include "brep/occt_shapes_impl.h"
#include "support/report_of.h"

namespace paver {
namespace {

/// One solid of the skins of boxes.
TopoDS_Solid solid_of(const std::vector<std::array<gp_Pnt, 2>>& boxes) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (const auto& [low, high] : boxes) builder.Add(solid, BRepPrimAPI_MakeBox(low, high).Shell());
  return solid;
}

RunReport sound_report(const TopoDS_Shape& shape, double size) {
  const RunReport report = test::report_of(shape, size);
  EXPECT_STREQ(verdict(report), "sound") << size;
  return report;
}

/// Of all faces.
double mesh_area(const RunReport& report) {
  double area = 0;
  for (const FaceReport& face : report.faces) area += face.mesh_area;
  return area;
}

TEST(TouchingItself, PadsAtACornerHaveItsEdgeInCommon) {
  const TopoDS_Solid pads = solid_of({{{{0, 0, 0}, {2, 2, 1}}}, {{{2, 2, 0}, {4, 4, 1}}}});
  for (const double size : {1e6, 0.5}) {
    const RunReport report = sound_report(pads, size);
    EXPECT_EQ(report.model.nonmanifold_edges, 1);
    EXPECT_EQ(report.model.free_edges, 0);
  }
}

TEST(TouchingItself, NodesLieOppositeWhereAnEdgeIsPartOfAnother) {
  const RunReport report = sound_report(solid_of({{{{0, 0, 0}, {2, 2, 3}}}, {{{2, 2, 1}, {4, 4, 2}}}}), 0.7);
  EXPECT_EQ(report.model.nonmanifold_edges, 1);
}

TEST(TouchingItself, NothingIsLeftBetweenSidesThatLieOnOneAnother) {
  const TopoDS_Solid bar = solid_of({{{{0, 0, 0}, {2, 2, 1}}}, {{{2, 0, 0}, {5, 2, 1}}}, {{{2, 2, 0}, {5, 4, 0.5}}}});
  const RunReport report = sound_report(bar, 0.5);
  EXPECT_TRUE(report.quality.watertight);
  EXPECT_NEAR(mesh_area(report), 2 * (5 * 2 + 5 * 1 + 2 * 1) + 2 * (3 * 2 + 3 * 0.5 + 2 * 0.5) - 2 * 3 * 0.5, 1e-6);
}

// What is left where one part was fused into another and both fit up to a few digits.
TEST(TouchingItself, OfVoidsAndPlatesWithoutHeightNoWallsStay) {
  constexpr double height = 1e-6;
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(20, 20, 2).Solid();
  BRep_Builder builder;
  TopoDS_Solid hollow;
  builder.MakeSolid(hollow);
  builder.Add(hollow, BRepPrimAPI_MakeBox(20, 20, 2).Shell());
  builder.Add(hollow, BRepPrimAPI_MakeBox(gp_Pnt{10, 10, 1}, 4, 6, height).Shell().Reversed());
  EXPECT_NEAR(mesh_area(sound_report(hollow, 3)), 2 * 20 * 20 + 4 * 20 * 2, 1e-6);
  TopoDS_Compound plated;
  builder.MakeCompound(plated);
  builder.Add(plated, block);
  builder.Add(plated, BRepPrimAPI_MakeBox(gp_Pnt{3, 3, 2}, 4, 6, height).Solid());
  EXPECT_NEAR(mesh_area(sound_report(plated, 3)), 2 * 20 * 20 + 4 * 20 * 2, 1e-6);
}

}  // namespace
}  // namespace paver
