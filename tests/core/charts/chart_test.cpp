// Charts on every kind of surface that has one: there and back, derivatives, orientation.
#include "charts/chart.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "brep/surfaces/evaluators_impl.h"
#include "support/fake_model.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

/// A surface with the box of (u, v) that a chart of it covers.
struct Case {
  std::string name;
  std::shared_ptr<const Surface> surface;
  ParameterBox box;
};

std::shared_ptr<const Surface> evaluator(const Handle(Geom_Surface) & surface) {
  return make_surface(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), 0);
}

/// Boxes with (lo, hi) as rows along u; `is_swapped` exchanges u and v.
ParameterBox make_box(Vec2 lo, Vec2 hi, bool is_swapped = false, bool low_pole = false, bool high_pole = false) {
  return {lo, hi, is_swapped, low_pole, high_pole};
}

std::vector<Case> row_cases() {
  gp_Ax3 axes(gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1), gp_Dir(2, 0, 1)), left = axes;
  left.YReverse();
  auto plane = std::make_shared<fake::Plane>(Vec3{1, 2, 3}, Vec3{0, 1, 0}, Vec3{0, 0, 1});
  auto cylinder = evaluator(new Geom_CylindricalSurface(axes, 2.5));
  auto cone = evaluator(new Geom_ConicalSurface(axes, 0.4, 2.5));
  auto sphere = evaluator(new Geom_SphericalSurface(left, 2.5));
  auto torus = evaluator(new Geom_ToroidalSurface(axes, 4, 1.5));
  auto hill = std::make_shared<fake::CubicPatch>(fake::hill(0.7));
  std::vector<Case> cases;
  for (bool is_swapped : {false, true}) {
    auto add = [&](const char* name, const std::shared_ptr<const Surface>& surface, ParameterBox box) {
      cases.push_back({name + std::string(is_swapped ? " swapped" : ""), surface, box});
    };
    add("plane", plane, make_box({-1e3, 5}, {1e3, 6}, is_swapped));
    add("cylinder", cylinder, make_box({0.1, 1}, {5, 4}, is_swapped));
    add("cone", cone, make_box({0.1, -2}, {5, 4}, is_swapped));
    add("sphere", sphere, make_box({0.1, -1.2}, {1.1, 1}, is_swapped));
    add("torus", torus, make_box({0, 0}, {2 * pi, 2 * pi}, is_swapped));
    add("hill", hill, make_box({0, 0.1}, {1, 0.9}, is_swapped));
  }
  cases.push_back({"sphere, both poles", sphere, make_box({0, -pi / 2}, {1, pi / 2}, false, true, true)});
  cases.push_back({"cone, apex", cone, make_box({0, -2.5 / std::sin(0.4)}, {2, 0}, false, true)});
  return cases;
}

std::vector<Case> polar_cases() {
  gp_Ax3 axes(gp_Pnt(1, -2, 3), gp_Dir(1, 2, -1), gp_Dir(2, 0, 1));
  auto cylinder = evaluator(new Geom_CylindricalSurface(axes, 2.5));
  auto cone = evaluator(new Geom_ConicalSurface(axes, 0.4, 2.5));
  auto sphere = evaluator(new Geom_SphericalSurface(axes, 2.5));
  auto torus = evaluator(new Geom_ToroidalSurface(axes, 4, 1.5));
  return {{"cylinder", cylinder, make_box({0, 1}, {2 * pi, 4})},
          {"cylinder, box from elsewhere", cylinder, make_box({1, 1}, {1 + 2 * pi, 4})},
          {"cone", cone, make_box({0, -2}, {2 * pi, 4})},
          {"cone, apex below", cone, make_box({0, -2.5 / std::sin(0.4)}, {2 * pi, 0}, false, true)},
          {"sphere, north cap", sphere, make_box({0, 0.3}, {2 * pi, pi / 2}, false, false, true)},
          {"sphere, south half", sphere, make_box({0, -pi / 2}, {2 * pi, 0}, false, true)},
          {"sphere, belt", sphere, make_box({0, -0.5}, {2 * pi, 1})},
          {"torus, cut along v", torus, make_box({0, 0}, {2 * pi, 2 * pi})},
          {"torus swapped, cut along u", torus, make_box({0, 0}, {2 * pi, 2 * pi}, true)},
          {"torus swapped, part", torus, make_box({0, 1}, {2 * pi, 3}, true)}};
}

Vec2 in_box(const ParameterBox& box, double s, double t) {
  return box.uv({box.lo.x + s * (box.hi.x - box.lo.x), box.lo.y + t * (box.hi.y - box.lo.y)});
}

void expect_round_trip(const Chart& chart, const ParameterBox& box) {
  Vec2 scale = box.hi - box.lo;
  if (box.is_swapped) std::swap(scale.x, scale.y);
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      bool is_pole = (j == 0 && box.low_pole) || (j == 40 && box.high_pole);
      bool is_seam = i == 0 || i == 40;  // either end of a period
      Vec2 uv = in_box(box, i / 40.0, j / 40.0), back = chart.uv(chart.to_chart(uv));
      double wrap = box.is_swapped ? back.y - uv.y : back.x - uv.x,
             other = box.is_swapped ? back.x - uv.x : back.y - uv.y;
      double period = box.is_swapped ? scale.y : scale.x;
      if (is_seam && std::fabs(wrap) > 0.5 * period) wrap -= std::copysign(period, wrap);
      EXPECT_NEAR(other, 0, 1e-9 * (box.is_swapped ? scale.x : scale.y)) << i << " " << j;
      if (is_pole) continue;  // any u
      EXPECT_NEAR(wrap, 0, 1e-9 * period) << i << " " << j;
    }
}

// Derivatives of (u, v) by the chart against central differences, inside the cells of the table.
void expect_derivatives(const Chart& chart, const ParameterBox& box) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.02, 0.98);
  Vec2 scale = box.hi - box.lo;
  if (box.is_swapped) std::swap(scale.x, scale.y);
  double size = norm(scale);
  for (int k = 0; k < 300; ++k) {
    Vec2 p = chart.to_chart(in_box(box, share(random), (std::floor(64 * share(random)) + 0.5) / 64));
    const auto [uv, uv_x, uv_y] = chart.slope(p);
    double step = 1e-4 / std::max({norm(uv_x), norm(uv_y)}) * 1e-2 * size;
    for (int axis = 0; axis < 2; ++axis) {
      Vec2 d = axis == 0 ? Vec2{step, 0} : Vec2{0, step}, expected = axis == 0 ? uv_x : uv_y;
      Vec2 slope = (0.5 / step) * (chart.uv(p + d) - chart.uv(p - d));
      ASSERT_NEAR(norm(slope - expected), 0, 1e-5 * (norm(uv_x) + norm(uv_y))) << k << " axis " << axis;
    }
    ASSERT_GT(cross(uv_x, uv_y), 0) << "orientation turned over";
  }
}

void expect_walks(const Chart& chart, const ParameterBox& box) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int k = 0; k < 100; ++k) {
    Vec2 p = chart.to_chart(in_box(box, share(random), share(random)));
    Vec2 q = chart.to_chart(in_box(box, share(random), share(random)));
    Vec2 end = chart.walk(p, chart.step_to(p, q));
    EXPECT_LE(norm(end - q), 1e-9 * (norm(q) + norm(p)));
    Vec2 small = 1e-6 * (q - p);
    EXPECT_LE(norm(chart.walk(p, small) - p - small), 1e-4 * norm(small) * (1 + norm(q) / norm(p)));
  }
}

/// Image of a small counter-clockwise circle in (u, v): must run counter-clockwise in the chart.
void expect_orientation(const Chart& chart, const ParameterBox& box) {
  for (double s : {0.1, 0.5, 0.9})
    for (double t : {0.1, 0.5, 0.9}) {
      Vec2 uv = in_box(box, s, t), extent = 0.01 * (box.hi - box.lo);
      if (box.is_swapped) std::swap(extent.x, extent.y);
      Vec2 p = chart.to_chart(uv), a = chart.to_chart(uv + Vec2{extent.x, 0}),
           b = chart.to_chart(uv + Vec2{0, extent.y});
      EXPECT_GT(cross(a - p, b - p), 0) << s << " " << t;
    }
}

TEST(RowChart, KeepsItsPromisesOnEverySurface) {
  for (const Case& c : row_cases()) {
    SCOPED_TRACE(c.name);
    auto chart = make_row_chart(*c.surface, c.box);
    expect_round_trip(*chart, c.box);
    expect_derivatives(*chart, c.box);
    expect_orientation(*chart, c.box);
    expect_walks(*chart, c.box);
  }
}

TEST(PolarChart, KeepsItsPromisesOnEverySurface) {
  for (const Case& c : polar_cases()) {
    SCOPED_TRACE(c.name);
    auto chart = make_polar_chart(*c.surface, c.box, 2 * pi);
    ASSERT_TRUE(chart);
    expect_round_trip(*chart, c.box);
    expect_derivatives(*chart, c.box);
    expect_orientation(*chart, c.box);
    expect_walks(*chart, c.box);
  }
}

TEST(RowChart, IsIsometricOnPlanesAndCylinders) {
  for (const Case& c : row_cases()) {
    if (!c.name.starts_with("plane") && !c.name.starts_with("cylinder")) continue;
    SCOPED_TRACE(c.name);
    auto chart = make_row_chart(*c.surface, c.box);
    const auto [uv, uv_x, uv_y] = chart->slope(chart->to_chart(in_box(c.box, 0.3, 0.6)));
    const auto [x, xu, xv] = c.surface->slope(uv);
    Vec3 a = uv_x.x * xu + uv_x.y * xv, b = uv_y.x * xu + uv_y.y * xv;
    EXPECT_NEAR(norm(a), 1, 1e-12);
    EXPECT_NEAR(norm(b), 1, 1e-12);
    EXPECT_NEAR(dot(a, b), 0, 1e-12);
  }
}

TEST(PolarChart, IsAboutConformalAndContinuousAcrossThePeriod) {
  for (const Case& c : polar_cases()) {
    if (c.name.starts_with("torus swapped")) continue;  // its rows are not all of one width
    SCOPED_TRACE(c.name);
    auto chart = make_polar_chart(*c.surface, c.box, 2 * pi);
    for (double t : {0.02, 0.3, 0.7, 0.98}) {
      Vec2 start = chart->to_chart(in_box(c.box, 0, t)), end = chart->to_chart(in_box(c.box, 1, t));
      EXPECT_LE(norm(start - end), 1e-12 * norm(start));
      const auto [uv, uv_x, uv_y] = chart->slope(chart->to_chart(in_box(c.box, 0.4, t)));
      const auto [x, xu, xv] = c.surface->slope(uv);
      Vec3 a = uv_x.x * xu + uv_x.y * xv, b = uv_y.x * xu + uv_y.y * xv;
      EXPECT_NEAR(norm(a) / norm(b), 1, 0.35) << t;
      EXPECT_NEAR(dot(a, b) / (norm(a) * norm(b)), 0, 0.15) << t;
    }
  }
}

TEST(PolarChart, MapsAPoleToTheOrigin) {
  for (const Case& c : polar_cases()) {
    if (!c.box.low_pole && !c.box.high_pole) continue;
    SCOPED_TRACE(c.name);
    auto chart = make_polar_chart(*c.surface, c.box, 2 * pi);
    EXPECT_LE(norm(chart->to_chart(in_box(c.box, 0.3, c.box.low_pole ? 0 : 1))), 1e-12);
    Vec3 pole = c.surface->point(in_box(c.box, 0.3, c.box.low_pole ? 0 : 1));
    EXPECT_LE(norm(c.surface->point(chart->uv({0, 0})) - pole), 1e-9);
  }
}

// A rod 80 times as long as its radius: the ends are e^80 apart in the chart.
TEST(PolarChart, WalksAlongARod) {
  const auto rod = evaluator(new Geom_CylindricalSurface(gp_Ax3(), 1));
  const ParameterBox box = make_box({0, 0}, {2 * pi, 80});
  const auto chart = make_polar_chart(*rod, box, 2 * pi);
  ASSERT_TRUE(chart);
  const Vec2 p = chart->to_chart({0.5, 0.1}), q = chart->to_chart({2, 79.9});
  EXPECT_LE(norm(chart->walk(p, chart->step_to(p, q)) - q), 1e-9 * norm(q));
  EXPECT_LE(norm(chart->walk(q, chart->step_to(q, p)) - p), 1e-9 * norm(p));
}

// Of a tenth of a degree from its axis to a degree: conformal ones would have radii of e^40 to e^2400.
TEST(PolarChart, NeedlesHaveOne) {
  for (double angle : {pi / 1800, pi / 600, pi / 180}) {
    SCOPED_TRACE(angle);
    const auto cone = evaluator(new Geom_ConicalSurface(gp_Ax3(), angle, 0));
    const ParameterBox box = make_box({0, 0}, {2 * pi, 30}, false, true);
    const auto chart = make_polar_chart(*cone, box, 2 * pi);
    ASSERT_TRUE(chart);
    expect_round_trip(*chart, box);
    expect_orientation(*chart, box);
  }
}

TEST(PolarChart, RefusesRadiiOutOfRange) {
  gp_Ax3 axes(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  auto wire = evaluator(new Geom_CylindricalSurface(axes, 0.001));
  EXPECT_FALSE(make_polar_chart(*wire, make_box({0, 0}, {2 * pi, 1}), 2 * pi));
  EXPECT_TRUE(make_polar_chart(*wire, make_box({0, 0}, {2 * pi, 0.01}), 2 * pi));
}

}  // namespace
}  // namespace paver
