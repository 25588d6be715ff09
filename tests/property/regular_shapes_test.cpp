// Spheres, tori, cylinders and cone frusta come out regular: no irregular node but the eight of a sphere, and lengths
// near the target.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAbs_SurfaceType.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <array>
#include <cmath>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>
#include <gp_GTrsf.hxx>
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
    EXPECT_LT(report.quality.length_cv, size < 10 ? 0.13 : 0.14);
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
      EXPECT_LT(report.quality.length_cv, size < 10 ? 0.13 : 0.14);
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

// Two triangles that meet along a thin face leave no elements as long as it is wide.
TEST(RegularShapes, ThinEllipses) {
  for (double ratio : {0.1, 0.15, 0.2, 0.3})
    for (double size : {7.1, 5.9, 5.0, 4.2, 3.6}) {
      const gp_Elips ellipse(gp_Ax2(), 50, 50 * ratio);
      const TopoDS_Wire rim = BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse).Edge()).Wire();
      const RunReport report = report_of(BRepBuilderAPI_MakeFace(rim, true).Face(), size);
      EXPECT_LT(report.quality.longest_edge, 1.8 * size) << ratio << " at " << size;
    }
}

TEST(RegularShapes, Spheres) {
  for (double size : sizes) {
    RunReport report = report_of(BRepPrimAPI_MakeSphere(50).Solid(), size);
    EXPECT_EQ(report.quality.irregular_nodes, 8) << size;
    EXPECT_LT(report.quality.length_cv, size > 10 ? 0.12 : 0.1);  // few elements: sides of the layout differ
  }
}

// As one face. Long ones have no layout for one length, flat ones a ridge all round.
TEST(RegularShapes, EllipsoidsAreMeshedAtEverySize) {
  for (auto [a, b, c] : {std::array{5, 2, 1}, {3, 2, 1}, {10, 10, 1}, {1, 1, 4}, {1, 1, 8}}) {
    gp_GTrsf scale;
    scale.SetVectorialPart(gp_Mat(a, 0, 0, 0, b, 0, 0, 0, c));
    const TopoDS_Shape shape = BRepBuilderAPI_GTransform(BRepPrimAPI_MakeSphere(1).Solid(), scale, true).Shape();
    const double diagonal = 2 * std::sqrt(a * a + b * b + c * c);
    for (double share : {0.5, 1.0, 2.0, 4.0, 6.0, 7.0, 8.5, 9.5, 10.5, 12.0, 16.0, 18.0, 30.0}) {
      SCOPED_TRACE(testing::Message() << a << " x " << b << " x " << c << ", diagonal/" << share);
      RunReport report = report_of(shape, diagonal / share);
      EXPECT_STREQ(verdict(report), "sound");
      EXPECT_LE(report.quality.triangles, 8);
      const double by_predicted = (report.quality.quads + report.quality.triangles) / report.quality.metric.predicted;
      // Where both halves are paved again, by lengths that do not count turns, there are half as many more.
      EXPECT_TRUE(share < 8 || by_predicted < 1.6) << by_predicted;
    }
  }
}

TEST(RegularShapes, Tori) {
  for (double size : sizes) {
    SCOPED_TRACE(size);
    RunReport report = report_of(BRepPrimAPI_MakeTorus(60, 22).Solid(), size);
    EXPECT_EQ(report.quality.triangles, 0);
    EXPECT_LE(report.quality.irregular_nodes, 48) << "four in each of up to twelve cells";
    EXPECT_LT(report.quality.length_cv, size < 10 ? 0.13 : 0.14);
    EXPECT_GT(report.quality.sj_all.mean, size < 10 ? 0.97 : 0.93);
  }
}

}  // namespace
}  // namespace paver
