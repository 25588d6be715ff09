// Rings of quads about apexes that a face goes round.
#include "paving/closing/fan_rings.h"

#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/brep/shape_files.h"
#include "support/paved_model.h"

namespace paver {
namespace {

test::PavedModel cone(double radius, double height, double h, int order = 2) {
  Options options;
  options.size = h;
  options.order = order;
  options.tip = 8;
  return {test::model_of(BRepPrimAPI_MakeCone(radius, 0, height).Shape()), options};
}

const RegionMesh& wall(const test::PavedModel& model) {
  const auto has_apex = [](const Region& region) { return !region.fans.empty(); };
  const auto found = std::find_if(model.regions.begin(), model.regions.end(), has_apex);
  return model.paved[static_cast<std::size_t>(found - model.regions.begin())];
}

TEST(FanRings, HaveAsManyColumnsAsTheTurnAsksForAndOneDistanceEach) {
  const test::PavedModel model = cone(75, 600, 24);
  const RegionMesh& mesh = wall(model);
  std::map<long, int> nodes_at;  // by the distance from the apex in 0.001 mm
  for (std::size_t i = 0; i < mesh.x.size(); ++i)
    if (mesh.star[i].size() > 0) ++nodes_at[std::lround(1e3 * norm(mesh.x[i] - Vec3{0, 0, 600}))];
  EXPECT_EQ(nodes_at.begin()->second, 1) << "the apex";
  int rings = 0;
  for (auto at = std::next(nodes_at.begin(), 3); at != nodes_at.end() && at->second == 8; ++at) ++rings;
  EXPECT_GE(rings, 6);
}

TEST(FanRings, GrowWithTheTargetLength) {
  const test::PavedModel model = cone(75, 600, 24);
  const RegionMesh& mesh = wall(model);
  for (const Element& e : mesh.elements) {
    if (!e.is_alive() || e.corners() != 4) continue;
    for (int k = 0; k < 4; ++k) {
      const int a = e.v[k], b = e.v[(k + 1) % 4];
      const double from = norm(mesh.x[a] - Vec3{0, 0, 600}), to = norm(mesh.x[b] - Vec3{0, 0, 600});
      if (from > to || from < 5 || to > 150 || to - from < 0.5 * from) continue;
      EXPECT_LT(to - from, 1.3 * mesh.h[b]) << from;
    }
  }
}

TEST(FanRings, LeaveNoTriangleAndOnlyTheApexAcute) {
  for (double h : {2.5, 5.0, 18.0, 24.0, 31.0}) {  // where turns count on the whole face, and not
    const test::PavedModel model = cone(75, 600, h);
    const RegionMesh& mesh = wall(model);
    for (const Element& e : mesh.elements) {
      if (!e.is_alive()) continue;
      EXPECT_EQ(e.corners(), 4);
      auto is_apex = [&](int v) { return norm(mesh.x[v] - Vec3{0, 0, 600}) < 1e-9; };
      const bool is_at_apex = std::any_of(e.v.begin(), e.v.end(), is_apex);
      EXPECT_GT(scaled_jacobian(mesh, e), is_at_apex ? 0.15 : 0.3) << h;
    }
  }
}

// An apple without its top: beyond the rim its surface comes back to the apex, at the lowest frequency within one step.
TEST(FanRings, StayWithinTheLoopWhereTheSurfaceGoesOnToTheApex) {
  const gp_Ax2 about(gp_Pnt(9, 0, 0), gp_Dir(0, -1, 0), gp_Dir(-1, 0, 0));  // from the axis downwards
  const Handle(Geom_Surface) surface = new Geom_SurfaceOfRevolution(new Geom_Circle(about, 10), gp_Ax1());
  const double apex = std::acos(0.9), rim = M_PI + std::asin(0.3);
  BRepBuilderAPI_MakeFace apple(surface, 0, 2 * M_PI, apex, rim, 1e-7);
  Options options;
  options.size = 1e6;
  const test::PavedModel model(test::model_of(apple.Shape()), options);
  EXPECT_GT(wall(model).living_elements(), 0);
  for (const Vec3& x : wall(model).x) EXPECT_LE(x.z, 3 + 1e-6);
}

TEST(FanRings, AreTheSameAtEitherOrder) {
  const test::PavedModel straight = cone(75, 600, 24, 1), curved = cone(75, 600, 24, 2);
  EXPECT_GT(wall(straight).node_count(), 0);
  EXPECT_EQ(wall(straight).x, wall(curved).x);
}

}  // namespace
}  // namespace paver
