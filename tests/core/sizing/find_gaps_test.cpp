#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>
#include <set>

#include "sizing/parts/find_places.h"
#include "support/plates.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::disc, test::plate;

std::vector<GapPiece> gaps(const TopoDS_Shape& shape, double h) {
  return find_gaps(test::model_of(shape), [h](int) { return h; });
}

/// A hole that leaves a strip of 4 mm along the lower side.
TopoDS_Shape plate_with_strip() { return BRepAlgoAPI_Cut(plate(0, 0, 100, 60), plate(20, 4, 80, 25)).Shape(); }

TEST(FindGaps, NoneOnWideFacesNorInTheirCorners) {
  EXPECT_TRUE(gaps(BRepPrimAPI_MakeBox(30, 20, 10).Shape(), 10).empty());
  EXPECT_TRUE(gaps(BRepAlgoAPI_Cut(plate(0, 0, 100, 60), disc(50, 30, 2)).Shape(), 10).empty()) << "across a hole";
}

TEST(FindGaps, AStripBetweenAHoleAndTheBorderFromBothSides) {
  const std::vector<GapPiece> found = gaps(plate_with_strip(), 10);
  ASSERT_FALSE(found.empty());
  double low = 1000, high = 0;
  std::set<double> from;
  for (const GapPiece& gap : found) {
    EXPECT_NEAR(gap.width, 4, 1e-9);
    EXPECT_NEAR(norm(gap.to - gap.from), 4, 1e-9);
    from.insert(gap.from.y);
    low = std::min({low, gap.from.x, gap.next_from.x}), high = std::max({high, gap.from.x, gap.next_from.x});
  }
  EXPECT_EQ(from, (std::set<double>{0, 4}));
  EXPECT_NEAR(low, 20, 2.6);
  EXPECT_NEAR(high, 80, 2.6);
  EXPECT_TRUE(gaps(plate_with_strip(), 5).empty()) << "wider than 0.7 h";
}

TEST(FindGaps, ANeckBetweenTwoHolesHasItsLeastWidth) {
  const TopoDS_Shape one = BRepAlgoAPI_Cut(plate(0, 0, 100, 60), disc(40, 30, 9)).Shape();
  double least = 1000;
  for (const GapPiece& gap : gaps(BRepAlgoAPI_Cut(one, disc(60, 30, 9)).Shape(), 10))
    least = std::min(least, gap.width);
  EXPECT_NEAR(least, 2, 0.1);
}

TEST(FindGaps, WedgesOfALargeAngleAreNone) {
  BRepBuilderAPI_MakePolygon triangle(gp_Pnt(0, 0, 0), gp_Pnt(60, 0, 0), gp_Pnt(0, 50, 0), true);
  EXPECT_TRUE(gaps(BRepBuilderAPI_MakeFace(triangle.Wire()).Shape(), 10).empty());
}

long elements(const TopoDS_Shape& shape, int across, double from, double to) {
  Options options;
  options.size = 10;
  options.gap_elements = across;
  const MeshResult result = test::mesh_of(shape, options);
  EXPECT_STREQ(verdict(result.report), "sound");
  long count = 0;
  const SurfaceMesh& mesh = result.mesh;
  for (std::size_t i = 0; i + 9 <= mesh.quads.size(); i += 9) {
    const Vec3 centre = mesh.nodes[static_cast<std::size_t>(mesh.quads[i + 8])];
    count += centre.y < 4 && centre.x > from && centre.x < to;
  }
  return count;
}

// In the middle of the strip, which is 4 wide, squares of 4 / K.
TEST(FindGaps, AsManyElementsAcrossAsAskedFor) {
  EXPECT_NEAR(static_cast<double>(elements(plate_with_strip(), 1, 30, 70)), 4, 1);
  EXPECT_NEAR(static_cast<double>(elements(plate_with_strip(), 2, 30, 70)), 40, 6);
  EXPECT_NEAR(static_cast<double>(elements(plate_with_strip(), 4, 30, 70)), 160, 24);
}

}  // namespace
}  // namespace paver
