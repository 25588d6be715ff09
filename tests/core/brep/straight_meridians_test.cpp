// Images that run round the pole which their edges lead to.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <Geom2dAPI_PointsToBSpline.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <numbers>

#include "brep/occt_shapes_impl.h"
#include "support/report_of.h"

namespace paver {
namespace {

constexpr double right = std::numbers::pi / 2, radius = 15;

/// At the last of these latitudes a circle round the pole is 1e-6 mm long.
Handle(Geom2d_Curve) turning(const EdgeImage& image, double turn) {
  constexpr int count = 25;
  TColgp_Array1OfPnt2d points(1, count);
  TColStd_Array1OfReal knots(1, count);
  TColStd_Array1OfInteger multiplicities(1, count);
  multiplicities.Init(1);
  multiplicities(1) = multiplicities(count) = 2;
  for (int i = 1; i <= count; ++i) {
    const double share = (i - 1) / (count - 1.0), bent = i == count ? 1 : share * (1 - 1e-8);
    points(i) = image.uv(bent);
    if (i == count) points(i).SetX(points(i).X() + turn);
    knots(i) = image.at(bent);
  }
  knots(count - 1) = image.at(1 - 1e-8);
  points(count - 1) = image.uv(1 - 1e-8);
  return new Geom2d_BSplineCurve(points, knots, multiplicities, 1);
}

/// Half a ball whose meridians turn by so much at one pole.
TopoDS_Shape half_ball(double turn) {
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(radius, -right, right, 2 * right).Shape();
  for (const TopoDS_Face& face : faces_of(ball)) {
    const TopoDS_Face plain = forward(face);
    const std::vector<TopoDS_Edge> edges = edges_of(plain);
    if (edges.size() < 4) continue;  // not round
    for (const TopoDS_Edge& edge : edges)
      if (!BRep_Tool::Degenerated(edge))
        BRep_Builder().UpdateEdge(edge, turning(image_of(edge, plain), turn), plain, BRep_Tool::Tolerance(edge));
  }
  return ball;
}

TEST(StraightMeridians, DoNotRunRoundTheirPole) {
  for (double turn : {0.3, -1.02}) {
    const MeshResult result = test::mesh_of(half_ball(turn), 3);
    EXPECT_STREQ(verdict(result.report), "sound") << turn;
    EXPECT_EQ(result.report.model.repairs.size(), 1U);
    double area = 0;
    for (const FaceReport& face : result.report.faces) area += face.mesh_area;
    EXPECT_NEAR(area, 3 * std::numbers::pi * radius * radius, 1);
  }
}

TEST(StraightMeridians, StayWhereTheyAre) { EXPECT_TRUE(test::mesh_of(half_ball(0), 3).report.model.repairs.empty()); }

}  // namespace
}  // namespace paver
