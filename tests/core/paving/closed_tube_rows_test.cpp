// Rows round slim tubes that no cut opens.
#include "paving/closing/closed_tube_rows.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>

#include "support/report_of.h"

namespace paver {
namespace {

constexpr double mast_radius = 0.7;

/// A mast of a length with a boom, a third of the way up.
TopoDS_Shape mast_with_boom(double length) {
  const gp_Ax2 up({0, 0, -length / 3}, gp_Dir(0, 0, 1)), out({0, 0, 0}, gp_Dir(1, 0, 0));
  return BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(up, mast_radius, length).Shape(),
                          BRepPrimAPI_MakeCylinder(out, 0.4, 30).Shape())
      .Shape();
}

// Needles, as many triangles as quads, and elements that ran through each other had come of it.
TEST(ClosedTubeRows, AMastWithABoomIsOfQuadsAtEverySize) {
  for (double length : {10.0, 20.0, 45.0})
    for (double h : {4.0, 10.0, 25.0, 1e6}) {
      const RunReport report = test::report_of(mast_with_boom(length), h);
      EXPECT_STREQ(verdict(report), "sound") << length << " at " << h;
      EXPECT_LE(report.quality.triangles, 2) << length << " at " << h;
      EXPECT_GT(report.quality.sj_all.min, 0.3) << length << " at " << h;
    }
}

// Beside the boom about as long as wide, far from it far longer, with as many columns everywhere.
TEST(ClosedTubeRows, GrowAwayFromWhatElseIsThere) {
  const SurfaceMesh mesh = test::mesh_of(mast_with_boom(45), 10).mesh;
  std::vector<double> heights;
  for (const Vec3 x : mesh.nodes)
    if (std::fabs(std::hypot(x.x, x.y) - mast_radius) < 1e-6 && x.z > 2) heights.push_back(x.z);
  std::ranges::sort(heights);
  std::vector<double> rings{heights[0]};  // of corners, and of the middles of columns
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (heights[i] > heights[i - 1] + 0.3) rings.push_back(heights[i]);
  ASSERT_GE(rings.size(), 7U);
  EXPECT_LT(rings[2] - rings[0], 3);
  EXPECT_GT(rings.back() - rings[rings.size() - 3], 8);
  for (std::size_t i = 2; i < rings.size(); ++i)
    EXPECT_GT(rings[i] - rings[i - 1], 0.9 * (rings[i - 1] - rings[i - 2]));
  EXPECT_EQ(heights.size(), 12 * rings.size());
}

// The flat is some hundredths of a millimetre wide: rows from it on must not run into the groove.
TEST(ClosedTubeRows, EndWhereAFunnelIsNoLongerSlim) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(10).Shape();
  const TopoDS_Shape flat =
      BRepAlgoAPI_Cut(ball, BRepPrimAPI_MakeBox(gp_Pnt{-30, -30, -59.99976}, 60, 60, 50).Shape()).Shape();
  const TopoDS_Shape groove = BRepPrimAPI_MakeCylinder(gp_Ax2({-15, 0, 8}, {1, 0, 0}), 4.8, 30).Shape();
  const RunReport report = test::report_of(BRepAlgoAPI_Cut(flat, groove).Shape(), 2.8);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_LT(report.quality.quads, 350);
  EXPECT_EQ(report.quality.triangles, 0);
  EXPECT_GT(report.quality.sj_all.min, 0.3);
}

}  // namespace
}  // namespace paver
