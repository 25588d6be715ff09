// Bodies whose end is pressed flat: its two sides share the edge there.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <gp.hxx>
#include <numbers>
#include <string>
#include <utility>

#include "support/report_of.h"

namespace paver {
namespace {

/// Of a quarter of a circle, from angle `quarter` times 90 degrees on, one of its four poles; `bulge` as a share of the
/// radius.
gp_Pnt2d pole_of_quarter(int quarter, int i, double bulge) {
  const double along[] = {1, 1, bulge, 0}, up[] = {0, bulge, 1, 1};
  gp_Pnt2d pole(along[i], up[i]);
  pole.Rotate(gp::Origin2d(), quarter * std::numbers::pi / 2);
  return pole;
}

/// A tube from a circle about x to a line along z, its seam `first` quarters from an end of that, the two halves of it
/// run through at different paces where the bulges differ; the line is flagged as a pole, as readers have it.
TopoDS_Face tube(int first, double left_bulge, double right_bulge, bool is_flat = true) {
  TColgp_Array2OfPnt poles(1, 2, 1, 13);
  for (int j = 0; j < 13; ++j) {
    const int quarter = (std::min(j / 3, 3) + first) % 4;
    const gp_Pnt2d at = pole_of_quarter(quarter, j == 12 ? 3 : j % 3, quarter < 2 ? left_bulge : right_bulge);
    poles.SetValue(1, j + 1, {0, 10 * at.Y(), 10 * at.X()});
    poles.SetValue(2, j + 1, {60, is_flat ? 0 : 5 * at.Y(), 10 * at.X()});
  }
  TColStd_Array1OfReal ends(1, 2), quarters(1, 5);
  TColStd_Array1OfInteger twice(1, 2), thrice(1, 5);
  ends(1) = 0, ends(2) = 1, twice(1) = twice(2) = 2;
  for (int k = 1; k <= 5; ++k) quarters(k) = k - 1, thrice(k) = k == 1 || k == 5 ? 4 : 3;
  const Handle(Geom_Surface) surface = new Geom_BSplineSurface(poles, ends, quarters, twice, thrice, 1, 3);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, 1e-6).Face();
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    double from = 0, to = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, from, to);
    if (curve->Value(from).X() > 59 && curve->Value(to).X() > 59) BRep_Builder().Degenerated(edge, true);
  }
  return face;
}

TEST(PressedFlat, EndsAreClosedWhereverTheSeamLies) {
  for (auto [first, bulge] : {std::pair{0, 0.55}, {1, 0.55}, {2, 0.55}, {3, 0.55}, {0, 0.4}, {1, 0.4}})
    for (double size : {14.0, 9.0, 6.0, 5.0, 4.0, 2.2}) {
      SCOPED_TRACE(testing::Message() << "seam at " << first << ", bulge " << bulge << ", size " << size);
      const RunReport report = test::report_of(tube(first, 0.55, bulge), size);
      EXPECT_STREQ(verdict(report), "sound") << report.faces[0].reason;
      for (const std::string& name : report.model.free_edge_names) EXPECT_EQ(name, report.model.free_edge_names[0]);
      EXPECT_NEAR(report.quality.border_edges, 2 * std::numbers::pi * 10 / size, 6) << "at the circle alone";
      EXPECT_LT(report.quality.distance.largest, 0.12 * size);
    }
}

/// Waved, across x = 20.
TopoDS_Face wall() {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i)
    for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(i == j ? 22 : 18, 15 * (i - 2), 15 * (j - 2));
  const Handle(Geom_Surface) surface = GeomConvert::SurfaceToBSplineSurface(new Geom_BezierSurface(poles));
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TEST(PressedFlat, BodiesAreConnectedToWhatCrossesThem) {
  for (int first : {0, 1, 2, 3}) {
    SCOPED_TRACE(testing::Message() << "seam at " << first);
    const RunReport report = test::report_of(test::compound({tube(first, 0.55, 0.55), wall()}), 4);
    EXPECT_EQ(report.model.contacts.size(), 1U);
    EXPECT_TRUE(report.model.unconnected.empty());
    EXPECT_STREQ(verdict(report), "sound") << report.faces[0].reason;
    EXPECT_NEAR(report.quality.mesh_area, report.model.area, 0.01 * report.model.area);
  }
}

TEST(PressedFlat, AnEndThatIsNotFlatStaysOpen) {
  const RunReport report = test::report_of(tube(1, 0.55, 0.55, false), 6);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_GT(report.quality.border_edges, 15) << "at two circles";
}

}  // namespace
}  // namespace paver
