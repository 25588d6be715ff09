// Sheets and shells that cross themselves away from their edges, told by their meshes.
#include "check/distance/crossings.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <cmath>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using Names = std::array<std::string, 2>;

TopoDS_Face polygon(std::initializer_list<gp_Pnt> corners) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& corner : corners) outline.Add(corner);
  outline.Close();
  return BRepBuilderAPI_MakeFace(outline.Wire()).Face();
}

RunReport report_of(const TopoDS_Shape& shape, double size, int order) {
  Options options;
  options.size = size;
  options.order = order;
  return test::mesh_of(shape, options).report;
}

/// A strip, 10 wide, along the curve at -1 to 1.
template <class Curve>
TopoDS_Shape strip(Curve at) {
  TColgp_Array1OfPnt points(0, 80);
  for (int i = 0; i <= 80; ++i) points.SetValue(i, at((i - 40) / 40.0));
  const TopoDS_Edge curve = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve());
  return BRepPrimAPI_MakePrism(curve, gp_Vec(0, 10, 0));
}

/// Comes back to x = 0 at z = 3 from both sides.
gp_Pnt loop(double share) {
  const double t = 2.5 * share;
  return {t * t * t - 3 * t, 0, t * t};
}

/// Three turns, one apart from the next.
gp_Pnt spiral(double share) {
  const double angle = 3 * M_PI * (share + 1), radius = 2 + angle / (2 * M_PI);
  return {radius * cos(angle), 0, radius * sin(angle)};
}

TEST(Crossings, AFaceThatCrossesItselfIsTold) {
  for (double size : {3.0, 1.0, 0.677, 0.4})  // at 0.677 nodes lie within a hundredth of it on either side
    for (int order : {1, 2}) {
      const RunReport report = report_of(strip(loop), size, order);
      ASSERT_EQ(report.crossings.size(), 1U) << size << " " << order;
      EXPECT_EQ(report.crossings[0].faces, (Names{"Face1", "Face1"}));
      EXPECT_NEAR(report.crossings[0].where.x, 0, 0.3 * size);
      EXPECT_NEAR(report.crossings[0].where.z, 3, 0.3 * size);
      EXPECT_STREQ(verdict(report), "doubtful");
    }
}

TEST(Crossings, AFaceThatPassesBesideItselfIsNot) {
  for (double size : {3.0, 0.6})
    for (int order : {1, 2}) EXPECT_TRUE(report_of(strip(spiral), size, order).crossings.empty()) << size << order;
}

// A flap bent up and down again, through the plate on whose edge it stands: its tip is at z = tip.
TopoDS_Shape flap_shell(double tip) {
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}));
  sewing.Add(polygon({{0, 0, 0}, {3, 0, 5}, {3, 10, 5}, {0, 10, 0}}));
  sewing.Add(polygon({{3, 0, 5}, {6, 0, tip}, {6, 10, tip}, {3, 10, 5}}));
  sewing.Perform();
  return sewing.SewedShape();
}

TEST(Crossings, FacesOfOneShellAreTold) {
  for (double size : {6.0, 0.7}) {
    const RunReport report = report_of(flap_shell(-3), size, 2);
    ASSERT_EQ(report.crossings.size(), 1U) << size;
    EXPECT_EQ(report.crossings[0].faces, (Names{"Face1", "Face3"}));
    EXPECT_NEAR(report.crossings[0].where.x, 4.875, 0.01);
    EXPECT_NEAR(report.crossings[0].where.z, 0, 0.01);
  }
  EXPECT_EQ(report_of(flap_shell(-0.0005), 0.7, 2).crossings.size(), 1U);
  EXPECT_TRUE(report_of(flap_shell(0.0005), 0.7, 2).crossings.empty());
}

}  // namespace
}  // namespace paver
