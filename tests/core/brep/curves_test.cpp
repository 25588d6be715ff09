// Curves of edges in space and on faces.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <numbers>

#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr double turn = 2 * std::numbers::pi;

TEST(CurveEvaluator, AgreesWithTheKernelUnderAPlacement) {
  gp_Trsf placement;
  placement.SetRotation(gp_Ax1(gp_Pnt(0, 1, 0), gp_Dir(1, 1, 3)), 0.7);
  TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(new Geom_Ellipse(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0, 1, 1)), 3, 2), 0.2, 5);
  edge.Move(TopLoc_Location(placement));
  auto curve = make_curve(edge);
  BRepAdaptor_Curve adaptor(edge);
  for (double t = 0.2; t < 5; t += 0.3) {
    gp_Pnt p;
    gp_Vec d, dd;
    adaptor.D2(t, p, d, dd);
    const CurveJet at = curve->jet(t);
    EXPECT_LE(norm(at.x - to_vec(p)) + norm(at.t - to_vec(d)) + norm(at.tt - to_vec(dd)), 1e-12);
    EXPECT_LE(norm(curve->point(t) - at.x), 1e-15);
  }
}

TEST(CurveEvaluator, UsesTheImageOnASurfaceWhereThereIsNoCurve) {
  Handle(Geom_Surface) cylinder = new Geom_CylindricalSurface(gp_Ax3(), 2);
  TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(1, 1)), cylinder, 0, 3);
  auto curve = make_curve(edge);
  ASSERT_TRUE(curve);
  constexpr double step = 1e-4;
  for (double t = 0.1; t < 3; t += 0.4) {
    double s = t / std::numbers::sqrt2;
    const CurveJet at = curve->jet(t);
    EXPECT_LE(norm(at.x - Vec3{2 * std::cos(s), 2 * std::sin(s), s}), 1e-14);
    Vec3 before = curve->point(t - step), after = curve->point(t + step);
    EXPECT_LE(norm(at.t - (0.5 / step) * (after - before)), 1e-7);
    EXPECT_LE(norm(at.tt - (1 / (step * step)) * (after + before - 2.0 * at.x)), 1e-6);
  }
}

TEST(ParameterCurveEvaluator, GivesBothSidesOfAPeriodicEdge) {
  TopoDS_Face side;
  for (TopExp_Explorer faces(BRepPrimAPI_MakeCylinder(1, 2).Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
    if (make_surface(TopoDS::Face(faces.Current()), 0)->kind() == SurfaceKind::cylinder)
      side = TopoDS::Face(faces.Current().Oriented(TopAbs_FORWARD));
  }
  std::vector<double> u;
  for (TopExp_Explorer edges(side, TopAbs_EDGE); edges.More(); edges.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
    if (!BRep_Tool::IsClosed(edge, side)) continue;
    double t0 = 0, t1 = 0;
    BRep_Tool::Range(edge, t0, t1);
    u.push_back(make_parameter_curve(edge, side, t0, t1)->uv(0.5 * (t0 + t1)).x);
  }
  ASSERT_EQ(u.size(), 2u);
  EXPECT_NEAR(std::min(u[0], u[1]), 0, 1e-12);
  EXPECT_NEAR(std::max(u[0], u[1]), turn, 1e-12);
}

TEST(ParameterCurveEvaluator, ProjectsWhereTheImageRunsAtAnotherPace) {
  TopoDS_Face face = TopoDS::Face(TopExp_Explorer(BRepPrimAPI_MakeCylinder(2, 3).Shape(), TopAbs_FACE).Current());
  face.Orientation(TopAbs_FORWARD);
  auto surface = make_surface(face, 0);
  auto curve = make_curve(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 1), gp::DZ()), 2), 0, 5));
  class Rough : public ParameterCurve {
    Vec2 uv(double t) const override { return {t + 0.3 * std::sin(turn * t / 5), 1.05}; }
  } rough;
  auto image = make_projected_image(face, curve, rough, 0, 5);
  ASSERT_TRUE(image);
  for (double t = 0; t <= 5; t += 0.037) EXPECT_LE(norm(surface->point(image->uv(t)) - curve->point(t)), 1e-9);
  EXPECT_NEAR(image->uv(4.9).x, 4.9, 1e-9) << "stays in the same turn";
}

// Steps from a pole lead anywhere.
TEST(ParameterCurveEvaluator, ProjectsFromAPoleIntoTheSameTurn) {
  constexpr double meridian = 1.5;
  TopoDS_Face face = TopoDS::Face(TopExp_Explorer(BRepPrimAPI_MakeSphere(2).Shape(), TopAbs_FACE).Current());
  face.Orientation(TopAbs_FORWARD);
  auto surface = make_surface(face, 0);
  const gp_Ax2 along({0, 0, 0}, gp_Dir(std::sin(meridian), -std::cos(meridian), 0),
                     gp_Dir(std::cos(meridian), std::sin(meridian), 0));
  auto curve = make_curve(BRepBuilderAPI_MakeEdge(gp_Circ(along, 2), -0.5 * M_PI, 1));
  class Elsewhere : public ParameterCurve {
    Vec2 uv(double t) const override { return {t > -1.5 ? meridian + 7 : meridian + 0.1, t}; }
  } rough;
  auto image = make_projected_image(face, curve, rough, -0.5 * M_PI, 1);
  ASSERT_TRUE(image);
  for (double t = -0.5 * M_PI; t <= 1; t += 0.037) {
    EXPECT_NEAR(image->uv(t).x, meridian, 1e-6) << t;
    EXPECT_NEAR(image->uv(t).y, t, 1e-6) << t;
  }
}

}  // namespace
}  // namespace paver
