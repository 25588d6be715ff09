// Spheres, tori, cylinders and cone frusta come out regular: no irregular node but the eight of a sphere, and lengths
// near the target.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <string>

#include "support/report_of.h"

namespace paver {
namespace {

using test::report_of;

/// The lateral face of a solid: all but the flat ones.
TopoDS_Shape bent_face(const TopoDS_Shape& solid) {
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    if (BRepAdaptor_Surface(TopoDS::Face(faces.Current())).GetType() != GeomAbs_Plane) return faces.Current();
  return {};
}

TopoDS_Shape frustum(double ratio) { return bent_face(BRepPrimAPI_MakeCone(50, 50 / ratio, 80).Solid()); }

constexpr double sizes[] = {17, 15, 9.3, 6.1, 3.7};

class Frusta : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Ratios, Frusta, testing::Values(1.1, 1.27, 1.4, 1.5, 1.6));

TEST_P(Frusta, AreRegularUpToFiveThirds) {
  for (double size : {9.3, 6.1, 3.7, 2.2}) {
    SCOPED_TRACE(size);
    RunReport report = report_of(frustum(GetParam()), size);
    EXPECT_EQ(report.quality.irregular_nodes, 0);
    EXPECT_EQ(report.quality.triangles, 0);
    EXPECT_LT(report.quality.length_cv, 0.13);
    EXPECT_GT(report.quality.length_in_band, 0.9999);
    EXPECT_GT(report.quality.sj_all.min, 0.95);
  }
}

TEST(RegularShapes, FrustaThatNarrowMoreKeepTheirLengths) {
  for (double ratio : {2.0, 3.0, 6.0})
    for (double size : {6.1, 3.7, 2.2}) {
      SCOPED_TRACE(testing::Message() << ratio << " at " << size);
      RunReport report = report_of(frustum(ratio), size);
      EXPECT_EQ(report.quality.triangles, 0);
      EXPECT_LT(report.quality.irregular_share, 0.08);
      EXPECT_LT(report.quality.length_cv, 0.13);
    }
}

TEST(RegularShapes, BentRodsAreMeshedAtAnySize) {
  for (double degrees : {60.0, 202.5, 310.0})
    for (double size : {20.0, 16.0, 13.0, 12.0, 9.0}) {
      SCOPED_TRACE(testing::Message() << degrees << " at " << size);
      RunReport report = report_of(BRepPrimAPI_MakeTorus(59.4, 23.7, degrees * M_PI / 180).Solid(), size);
      EXPECT_TRUE(report.quality.watertight);
      EXPECT_LE(report.quality.triangles, 2);
      EXPECT_GT(report.quality.sj_all.min, 0.3);
    }
}

TEST(RegularShapes, Cylinders) {
  for (double size : sizes) {
    RunReport report = report_of(bent_face(BRepPrimAPI_MakeCylinder(50, 90).Solid()), size);
    EXPECT_EQ(report.quality.irregular_nodes, 0) << size;
    EXPECT_GT(report.quality.sj_all.min, 0.95);
  }
}

TEST(RegularShapes, Spheres) {
  for (double size : sizes) {
    RunReport report = report_of(BRepPrimAPI_MakeSphere(50).Solid(), size);
    EXPECT_EQ(report.quality.irregular_nodes, 8) << size;
    EXPECT_LT(report.quality.length_cv, size > 10 ? 0.12 : 0.1);  // few elements: sides of the layout differ
  }
}

TEST(RegularShapes, Tori) {
  for (double size : sizes) {
    SCOPED_TRACE(size);
    RunReport report = report_of(BRepPrimAPI_MakeTorus(60, 22).Solid(), size);
    EXPECT_EQ(report.quality.triangles, 0);
    EXPECT_LE(report.quality.irregular_nodes, 48) << "four in each of up to twelve cells";
    EXPECT_LT(report.quality.length_cv, 0.13);
    EXPECT_GT(report.quality.sj_all.mean, size < 10 ? 0.97 : 0.93);
  }
}

}  // namespace
}  // namespace paver
