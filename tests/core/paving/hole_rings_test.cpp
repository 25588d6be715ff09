// Rings of quads about small holes.
#include "paving/closing/hole_rings.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>

#include "support/report_of.h"

namespace paver {
namespace {

/// The top of a plate of 100 x 100 with holes that have a radius of 0.5.
TopoDS_Shape plate_with_holes(const std::vector<gp_Pnt>& middles) {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-50, -50, 0), gp_Pnt(50, 50, 1)).Shape();
  for (const gp_Pnt& middle : middles)
    plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(gp_Ax2(middle, gp_Dir(0, 0, 1)), 0.5, 4).Shape()).Shape();
  return plate;
}

// A probe's hole beside the middle: needles, and a triangle of a quarter of the plate, had come of it.
TEST(HoleRings, AHoleBesideTheMiddleIsMeshedAtEverySize) {
  for (double h : {8.0, 15.0, 30.0, 80.0, 1e6}) {
    const RunReport report = test::report_of(plate_with_holes({{10, 0, -2}}), h);
    EXPECT_STREQ(verdict(report), "sound") << h;
    EXPECT_GT(report.quality.sj_all.min, 0.12) << h;
    EXPECT_LE(report.quality.triangles, 12) << h;
  }
}

// The innermost ring is as far from the hole as its facets are long.
TEST(HoleRings, AreAsWideAsTheirColumns) {
  const SurfaceMesh mesh = test::mesh_of(plate_with_holes({{10, 0, -2}}), 30).mesh;
  std::vector<double> away;  // of nodes of the plate's top
  for (const Vec3 x : mesh.nodes)
    if (x.z == 1) away.push_back(std::hypot(x.x - 10, x.y));
  std::ranges::sort(away);
  const auto columns = std::ranges::count_if(away, [](double r) { return r < 0.5 + 1e-9; }) / 2;
  ASSERT_GE(columns, 6);
  const double ring = away[static_cast<std::size_t>(4 * columns)];  // corners and middles; of columns; corners
  EXPECT_NEAR(ring / (0.5 * (1 + 2 * M_PI / static_cast<double>(columns))), 1, 0.15);
}

// As many nodes as the border has: one row, as there is nothing to grow for.
TEST(HoleRings, AtTheLowestFrequencyOneRingOfQuadsIsEnough) {
  const RunReport report = test::report_of(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(50, 1).Shape(), BRepPrimAPI_MakeCylinder(0.5, 1).Shape()).Shape(), 1e6);
  for (const FaceReport& face : report.faces) EXPECT_EQ(face.quads, 8) << face.name;
  EXPECT_GT(report.quality.sj_all.min, 0.7);
}

TEST(HoleRings, HolesSideBySideShareTheRoomBetweenThem) {
  for (double gap : {0.3, 1.0, 3.0})
    for (double h : {10.0, 40.0}) {
      const RunReport report = test::report_of(plate_with_holes({{10, 0, -2}, {11 + gap, 0, -2}}), h);
      EXPECT_STREQ(verdict(report), "sound") << gap << " at " << h;
    }
}

// Lengths had grown by the gradation from each hole on, more slowly than rings, from the size on that holes are apart.
TEST(HoleRings, ManyHolesHaveHardlyMoreElementsAtLongerTargetLengths) {
  std::vector<gp_Pnt> middles;
  for (double x : {-30, 0, 30})
    for (double y : {-30, 0, 30}) middles.emplace_back(x, y, -2);
  const TopoDS_Shape plate = plate_with_holes(middles);
  auto elements = [&](double h) {
    const QualityReport quality = test::report_of(plate, h).quality;
    return static_cast<double>(quality.quads + quality.triangles);
  };
  const double apart = elements(20);
  for (double h : {50.0, 1e6}) EXPECT_LE(elements(h), 1.2 * apart) << h;
}

}  // namespace
}  // namespace paver
