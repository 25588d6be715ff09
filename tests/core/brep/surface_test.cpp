// Surface evaluators against OpenCASCADE's own, with placements and left-handed axes.
#include "brep/surfaces/surface.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <cmath>
#include <numbers>
#include <thread>
#include <vector>

#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

gp_Ax3 axes(bool is_left_handed) {
  gp_Ax3 result(gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1), gp_Dir(2, 0, 1));
  if (is_left_handed) result.YReverse();
  return result;
}

TopoDS_Face placed_face(const Handle(Geom_Surface) & surface, double u0, double u1, double v0, double v1) {
  gp_Trsf placement;
  placement.SetRotation(gp_Ax1(gp_Pnt(0, 1, 0), gp_Dir(1, 1, 3)), 0.7);
  placement.SetTranslationPart(gp_Vec(5, 6, -7));
  BRepBuilderAPI_MakeFace maker(surface, u0, u1, v0, v1, 1e-7);
  return TopoDS::Face(maker.Face().Moved(TopLoc_Location(placement)));
}

/// A wavy square patch of degree 3 over [0, 1] x [0, 1].
Handle(Geom_BSplineSurface) wavy_patch() {
  TColgp_Array2OfPnt poles(1, 6, 1, 6);
  for (int i = 1; i <= 6; ++i)
    for (int j = 1; j <= 6; ++j) poles(i, j) = gp_Pnt(i, j, std::sin(i) * std::cos(2 * j));
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger counts(1, 4);
  for (int i = 1; i <= 4; ++i) {
    knots(i) = (i - 1) / 3.0;
    counts(i) = i == 1 || i == 4 ? 4 : 1;
  }
  return new Geom_BSplineSurface(poles, knots, knots, counts, counts, 3, 3);
}

/// A tube as open B-spline whose ends coincide up to `gap`.
Handle(Geom_BSplineSurface) tube(double gap) {
  TColgp_Array2OfPnt poles(1, 9, 1, 2);
  for (int i = 1; i <= 9; ++i) {
    double a = 2 * std::numbers::pi * (i - 1) / 8;
    for (int j = 1; j <= 2; ++j) poles(i, j) = gp_Pnt(std::cos(a) + (i == 9 ? gap : 0), std::sin(a), j);
  }
  TColStd_Array1OfReal u_knots(1, 9), v_knots(1, 2);
  TColStd_Array1OfInteger u_counts(1, 9), v_counts(1, 2);
  for (int i = 1; i <= 9; ++i) {
    u_knots(i) = i;
    u_counts(i) = i == 1 || i == 9 ? 2 : 1;
  }
  for (int i = 1; i <= 2; ++i) {
    v_knots(i) = i;
    v_counts(i) = 2;
  }
  return new Geom_BSplineSurface(poles, u_knots, v_knots, u_counts, v_counts, 1, 1);
}

void expect_near(Vec3 a, Vec3 b, double tolerance) { EXPECT_LE(norm(a - b), tolerance * (1 + norm(b))); }

void expect_same_as_kernel(const TopoDS_Face& face, SurfaceKind kind) {
  auto surface = make_surface(face, 0);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->kind(), kind);
  auto copy = surface->clone();
  BRepAdaptor_Surface adaptor(face);
  for (int i = 0; i <= 7; ++i) {
    for (int j = 0; j <= 7; ++j) {
      double u = adaptor.FirstUParameter() + (adaptor.LastUParameter() - adaptor.FirstUParameter()) * i / 7;
      double v = adaptor.FirstVParameter() + (adaptor.LastVParameter() - adaptor.FirstVParameter()) * j / 7;
      gp_Pnt p;
      gp_Vec pu, pv, puu, pvv, puv;
      adaptor.D2(u, v, p, pu, pv, puu, pvv, puv);
      const SurfaceJet at = surface->jet({u, v});
      expect_near(at.x, to_vec(p), 1e-13);
      expect_near(at.u, to_vec(pu), 1e-12);
      expect_near(at.v, to_vec(pv), 1e-12);
      expect_near(at.uu, to_vec(puu), 1e-11);
      expect_near(at.uv, to_vec(puv), 1e-11);
      expect_near(at.vv, to_vec(pvv), 1e-11);
      const auto [x, xu, xv] = copy->slope({u, v});
      expect_near(x, to_vec(p), 1e-13);
      expect_near(xu, to_vec(pu), 1e-12);
      expect_near(copy->point({u, v}), to_vec(p), 1e-13);
    }
  }
}

TEST(SurfaceEvaluator, AgreesWithTheKernelOnElementarySurfacesAlsoLeftHandedOnes) {
  for (bool is_left_handed : {false, true}) {
    gp_Ax3 a = axes(is_left_handed);
    expect_same_as_kernel(placed_face(new Geom_Plane(a), -1, 2, -3, 1), SurfaceKind::plane);
    expect_same_as_kernel(placed_face(new Geom_CylindricalSurface(a, 2.5), 0.1, 5, -3, 1), SurfaceKind::cylinder);
    expect_same_as_kernel(placed_face(new Geom_ConicalSurface(a, 0.4, 2.5), 0.1, 5, -3, 1), SurfaceKind::cone);
    expect_same_as_kernel(placed_face(new Geom_SphericalSurface(a, 2.5), 0.1, 5, -1.5, 1), SurfaceKind::sphere);
    expect_same_as_kernel(placed_face(new Geom_ToroidalSurface(a, 4, 1.5), 0.1, 5, -1.5, 1), SurfaceKind::torus);
  }
}

TEST(SurfaceEvaluator, AgreesWithTheKernelOnOtherSurfaces) {
  Handle(Geom_Curve) ellipse = new Geom_Ellipse(gp_Ax2(gp_Pnt(5, 0, 0), gp_Dir(0, 1, 0)), 2, 1);
  expect_same_as_kernel(placed_face(wavy_patch(), 0, 1, 0, 1), SurfaceKind::other);
  expect_same_as_kernel(placed_face(new Geom_SurfaceOfRevolution(ellipse, gp::OZ()), 0.2, 4, 0.1, 3),
                        SurfaceKind::other);
  expect_same_as_kernel(placed_face(new Geom_SurfaceOfLinearExtrusion(ellipse, gp_Dir(1, 2, 3)), 0.2, 4, 0.1, 3),
                        SurfaceKind::other);
  expect_same_as_kernel(placed_face(new Geom_OffsetSurface(wavy_patch(), 0.01), 0, 1, 0, 1), SurfaceKind::other);
}

/// A rational surface of degrees 8 and `degree`, with a double knot in v, weights between 0.5 and 1.5.
Handle(Geom_BSplineSurface) rational_patch(int degree) {
  const int rows = 9, columns = 2 * degree + 3;
  TColgp_Array2OfPnt poles(1, rows, 1, columns);
  TColStd_Array2OfReal weights(1, rows, 1, columns);
  for (int i = 1; i <= rows; ++i)
    for (int j = 1; j <= columns; ++j) {
      poles(i, j) = gp_Pnt(i, j, std::sin(3 * i) * std::cos(2 * j));
      weights(i, j) = 1 + 0.5 * std::sin(i + 5 * j);
    }
  TColStd_Array1OfReal u_knots(1, 2), v_knots(1, 3 + degree / 2);
  TColStd_Array1OfInteger u_counts(1, 2), v_counts(1, 3 + degree / 2);
  for (int i = 1; i <= 2; ++i) u_knots(i) = i, u_counts(i) = 9;
  int left = columns + degree + 1 - 2 * (degree + 1), inner = v_knots.Length() - 2;
  for (int i = 1; i <= v_knots.Length(); ++i) {
    bool is_end = i == 1 || i == v_knots.Length();
    v_knots(i) = 0.3 * i * i;
    v_counts(i) = is_end ? degree + 1 : i - 1 < inner ? left / inner : left - (inner - 1) * (left / inner);
  }
  return new Geom_BSplineSurface(poles, weights, u_knots, v_knots, u_counts, v_counts, 8, degree);
}

TEST(SurfaceEvaluator, AgreesWithTheKernelOnSplinesOfAllKinds) {
  for (int degree : {2, 3, 5}) {
    Handle(Geom_BSplineSurface) patch = rational_patch(degree);
    double u0, u1, v0, v1;
    patch->Bounds(u0, u1, v0, v1);
    expect_same_as_kernel(placed_face(patch, u0, u1, v0, v1), SurfaceKind::other);
  }
  Handle(Geom_BSplineSurface) ring = GeomConvert::SurfaceToBSplineSurface(new Geom_ToroidalSurface(axes(true), 4, 1.5));
  ASSERT_TRUE(ring->IsUPeriodic() && ring->IsVPeriodic() && ring->IsURational());
  expect_same_as_kernel(placed_face(ring, 0.1, 5, 0.2, 3), SurfaceKind::other);
  TColgp_Array2OfPnt poles(1, 2, 1, 8);
  TColStd_Array2OfReal weights(1, 2, 1, 8);
  for (int i = 1; i <= 2; ++i)
    for (int j = 1; j <= 8; ++j) poles(i, j) = gp_Pnt(3 * i, j, std::sin(i * j)), weights(i, j) = 1 + 0.1 * i * (j % 3);
  expect_same_as_kernel(placed_face(new Geom_BezierSurface(poles, weights), 0, 1, 0, 1), SurfaceKind::other);
}

TEST(SurfaceEvaluator, LooksUnderTrims) {
  Handle(Geom_Surface) trimmed = new Geom_RectangularTrimmedSurface(new Geom_Plane(axes(false)), 0.0, 1.0, 0.0, 1.0);
  expect_same_as_kernel(placed_face(trimmed, 0.1, 0.9, 0.1, 0.9), SurfaceKind::plane);
}

TEST(SurfaceEvaluator, KnowsWhereSurfacesClose) {
  constexpr double turn = 2 * std::numbers::pi;
  auto period = [](const Handle(Geom_Surface) & surface, double tolerance) {
    BRepBuilderAPI_MakeFace maker(surface, 1.1, 1.9, 1.1, 1.4, 1e-7);
    return make_surface(maker.Face(), tolerance)->period();
  };
  EXPECT_EQ(period(new Geom_Plane(axes(false)), 0), (Vec2{0, 0}));
  EXPECT_EQ(period(new Geom_CylindricalSurface(axes(false), 1), 0), (Vec2{turn, 0}));
  EXPECT_EQ(period(new Geom_SphericalSurface(axes(false), 1), 0), (Vec2{turn, 0}));
  EXPECT_EQ(period(new Geom_ToroidalSurface(axes(false), 3, 1), 0), (Vec2{turn, turn}));
  EXPECT_EQ(period(tube(0), 0), (Vec2{8, 0}));
  EXPECT_EQ(period(tube(1e-3), 0), (Vec2{0, 0}));
  EXPECT_EQ(period(tube(1e-3), 2e-3), (Vec2{8, 0})) << "closed within the tolerance of its edge";
}

TEST(SurfaceEvaluator, WrapsAcrossAClosedDirection) {
  auto surface = make_surface(BRepBuilderAPI_MakeFace(tube(0), 1, 9, 1, 2, 1e-7).Face(), 0);
  expect_near(surface->point({9.5, 1.5}), surface->point({1.5, 1.5}), 1e-14);
  expect_near(surface->point({0.25, 1.5}), surface->point({8.25, 1.5}), 1e-14);
}

TEST(SurfaceEvaluator, ContinuesBoundedSurfacesLinearlyAndStaysFinite) {
  auto surface = make_surface(BRepBuilderAPI_MakeFace(wavy_patch(), 0, 1, 0, 1, 1e-7).Face(), 0);
  const auto [x, xu, xv] = surface->slope({3, -2});
  expect_near(surface->slope({4, -2}).x, x + xu, 1e-9);
  expect_near(surface->point({3, -2}), x, 1e-12);
  for (double far : {-1e6, 1e6}) EXPECT_TRUE(std::isfinite(norm(surface->point({far, -far}))));
}

TEST(SurfaceEvaluator, ClonesWorkSideBySide) {
  auto surface = make_surface(BRepBuilderAPI_MakeFace(wavy_patch(), 0, 1, 0, 1, 1e-7).Face(), 0);
  std::vector<Vec3> sums(4);
  std::vector<std::thread> threads;
  for (Vec3& sum : sums) {
    threads.emplace_back([&sum, mine = std::shared_ptr<Surface>(surface->clone())] {
      for (int i = 0; i < 2000; ++i) sum += mine->point({(i % 41) / 40.0, (i % 37) / 36.0});
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const Vec3& sum : sums) EXPECT_EQ(sum, sums[0]);
}

}  // namespace
}  // namespace paver
