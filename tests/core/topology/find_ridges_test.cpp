// Faces that turn over within a small part of their width: divided along that line where elements cannot follow it.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <gp.hxx>
#include <gp_Ax2.hxx>
#include <numbers>
#include <vector>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::model_of;

constexpr int points = 40;

/// An ellipse of 40 mm by `thickness`, bent by `camber`, as a spline that starts after `start` of its way round; whole,
/// or half of it. Bent ones close without being periodic, as lofts would start periodic ones elsewhere.
TopoDS_Wire section(double thickness, double z, double twist, double start, bool is_whole, double camber = 0) {
  const bool is_periodic = is_whole && camber == 0;
  const int count = is_periodic ? points : is_whole ? points + 1 : points / 2 + 1;
  Handle(TColgp_HArray1OfPnt) places = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (start + static_cast<double>(i) / points);
    const double x = 20 * std::cos(angle);
    const double y = 0.5 * thickness * std::sin(angle) + camber * (1 - std::cos(angle) * std::cos(angle));
    places->SetValue(i + 1,
                     gp_Pnt(x * std::cos(twist) - y * std::sin(twist), x * std::sin(twist) + y * std::cos(twist), z));
  }
  GeomAPI_Interpolate curve(places, is_periodic, 1e-9);
  curve.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge()).Wire();
}

/// From a section to another one 100 mm above, turned by `twist` and less bent.
TopoDS_Shape blade(double thickness, double twist, double start, bool is_whole, double camber = 0) {
  BRepOffsetAPI_ThruSections loft(is_whole, true);
  loft.AddWire(section(thickness, 0, 0, start, is_whole, camber));
  loft.AddWire(section(thickness, 100, twist, start, is_whole, 0.25 * camber));
  loft.Build();
  return loft.Shape();
}

Options with_size(double size) {
  Options options;
  options.size = size;
  return options;
}

constexpr double half_of_it = 0.25;  // from the middle of one side round the nose to that of the other

TEST(FindRidges, CutANoseThatElementsCannotFollow) {
  const Model model = model_of(blade(2, 0.3, half_of_it, false), with_size(10));
  ASSERT_EQ(model.faces.size(), 2u);
  EXPECT_NEAR(model.faces[0].area, model.faces[1].area, 0.01 * model.faces[0].area);
  for (const Edge& edge : model.edges)
    if (edge.faces.size() == 2)
      for (const double share : {0.0, 0.5, 1.0}) {
        const Vec3 at = edge.curve->point(edge.t0 + share * (edge.t1 - edge.t0));
        // The loft is straight between its sections.
        EXPECT_NEAR(std::hypot(at.x, at.y), share == 0.5 ? 20 * std::cos(0.15) : 20, 0.02) << "off the nose";
      }
}

TEST(FindRidges, LeaveWhatElementsFollow) {
  // The nose turns by a right angle within 0.08 mm: elements of 0.3 mm are as narrow as 0.04 mm there.
  EXPECT_EQ(model_of(blade(2, 0.3, half_of_it, false), with_size(0.3)).faces.size(), 1u);
}

TEST(FindRidges, LeaveRoundFacesWholeAtAnyLength) {
  EXPECT_EQ(model_of(blade(30, 0.3, half_of_it, false), with_size(1e6)).faces.size(), 1u);
}

TEST(FindRidges, CutASmallRoundingAsWellAsLengthsOfElementsAskIt) {
  Options options = with_size(0.3);
  options.aspect = 1;
  EXPECT_EQ(model_of(blade(2, 0.3, half_of_it, false), options).faces.size(), 2u);
}

TEST(FindRidges, AClosedSkinThatStartsOnANoseBecomesItsTwoSides) {
  const Model model = model_of(blade(1, 0, 0, true), with_size(10));
  ASSERT_EQ(model.faces.size(), 4u);  // with its caps
  std::vector<double> areas;
  for (const Face& face : model.faces) areas.push_back(face.area);
  std::ranges::sort(areas);
  EXPECT_NEAR(areas[2], areas[3], 0.01 * areas[3]);
  EXPECT_NEAR(areas[3], 4000, 40);
}

TEST(FindRidges, AClosedSkinThatStartsAsideIsCutAlongBothNoses) {
  const Model model = model_of(blade(1, 0, half_of_it, true), with_size(10));
  EXPECT_EQ(std::ranges::count_if(model.edges, [](const Edge& edge) { return edge.name.starts_with("Added"); }), 2);
}

TEST(FindRidges, ThinTwistedBladesAreOnTheSurfaceAtEveryLength) {
  for (const double size : {1e6, 20.0, 6.0, 2.0}) {
    const RunReport report = test::report_of(blade(1, 0.8, half_of_it, false), size);
    EXPECT_STREQ(verdict(report), "sound") << size;
    EXPECT_EQ(report.quality.triangles, 0) << size;
    EXPECT_GT(report.quality.sj_all.min, 0.6) << size;
    for (const FaceReport& face : report.faces) EXPECT_LT(face.distance.largest, 0.05 * std::min(size, 5.0)) << size;
  }
}

/// The outer side of a bent section is longer: where it is less bent the nose has another parameter.
constexpr double camber = 4;

long points_off_the_nose(const Model& model) {
  long count = 0;
  for (const Edge& edge : model.edges) {
    if (edge.faces.size() != 2) continue;
    for (int i = 0; i <= 20; ++i) count += edge.curve->point(edge.t0 + 0.05 * i * (edge.t1 - edge.t0)).x > -19.98;
  }
  return count;
}

TEST(FindRidges, ANoseThatWandersOverTheParametersIsCutAllAlong) {
  const Model model = model_of(blade(1, 0, half_of_it, false, camber), with_size(10));
  ASSERT_EQ(model.faces.size(), 2u);
  EXPECT_EQ(points_off_the_nose(model), 0);
}

TEST(FindRidges, AWanderingNoseIsCutBetweenAnyBorders) {
  const TopoDS_Shape whole = blade(1, 0, half_of_it, false, camber);
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-22, -10, 50), gp::DY()), 6, 20).Shape();
  const TopoDS_Shape slope = BRepPrimAPI_MakeBox(gp_Ax2(gp_Pnt(-30, -10, 80), gp_Dir(0.3, 0, 1)), 80, 20, 50).Shape();
  const TopoDS_Shape cut = BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(whole, hole).Shape(), slope).Shape();
  const Model model = model_of(cut, with_size(10));
  ASSERT_EQ(model.faces.size(), 2u);
  EXPECT_EQ(std::ranges::count_if(model.edges, [](const Edge& edge) { return edge.faces.size() == 2; }), 2);
  EXPECT_EQ(points_off_the_nose(model), 0);
}

TEST(FindRidges, WanderingNosesEndWhereThoseOfNeighboursDo) {
  BRepOffsetAPI_ThruSections even(false, true);  // so little bent that an iso-line stays in the turn
  even.AddWire(section(1, 100, 0, half_of_it, false, 0.25 * camber));
  even.AddWire(section(1, 200, 0, half_of_it, false, 0.2 * camber));
  even.Build();
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(blade(1, 0, half_of_it, false, camber));
  sewing.Add(even.Shape());
  sewing.Perform();
  const Model model = model_of(sewing.SewedShape(), with_size(10));
  ASSERT_EQ(model.faces.size(), 4u);
  for (const Edge& edge : model.edges)
    EXPECT_GT(norm(edge.curve->point(edge.t1) - edge.curve->point(edge.t0)), 0.5) << edge.name;
}

TEST(FindRidges, CapsTakeOverTheEndsOfWanderingNoses) {
  for (const double size : {1e6, 10.0, 3.0}) {
    const RunReport report = test::report_of(blade(1, 0.3, half_of_it, true, camber), size);
    EXPECT_STREQ(verdict(report), "sound") << size;
    for (const FaceReport& face : report.faces) EXPECT_LT(face.distance.largest, 0.02 * std::min(size, 10.0)) << size;
  }
}

}  // namespace
}  // namespace paver
