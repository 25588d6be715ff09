// Poles: where a surface comes to a point, and where it only seems to.
#include "charts/pole.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <numbers>

#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr double pi = std::numbers::pi;

std::shared_ptr<const Surface> evaluator(const Handle(Geom_Surface) & surface) {
  return make_surface(BRepBuilderAPI_MakeFace(surface, 1e-7).Face(), 0);
}

TEST(Pole, IsSharpOnAConeAndSmoothOnASphere) {
  auto sphere = evaluator(new Geom_SphericalSurface(gp_Ax3(), 10));
  auto cone = evaluator(new Geom_ConicalSurface(gp_Ax3(), pi / 6, 10));
  PoleShape smooth = measure_pole(*sphere, {{0, -pi / 2}, {2 * pi, pi / 2}, false, true, true}, 2 * pi, false);
  EXPECT_FALSE(smooth.is_sharp());
  EXPECT_NEAR(smooth.cone_angle, 2 * pi, 0.01);
  EXPECT_LE(norm(smooth.apex - Vec3{0, 0, 10}), 1e-12);
  PoleShape apex = measure_pole(*cone, {{0, -20}, {2 * pi, 0}, false, true, false}, 2 * pi, true);
  EXPECT_TRUE(apex.is_sharp());
  EXPECT_NEAR(apex.cone_angle, pi, 0.01);  // a half disk, rolled up
}

}  // namespace
}  // namespace paver
