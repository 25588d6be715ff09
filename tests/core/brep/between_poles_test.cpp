// Closed surfaces of revolution whose meridian comes to the axis: spindles are in small_step_test.cpp.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>

#include "core/brep/shape_files.h"

namespace paver {
namespace {

int poles_of(const Model& model) {
  int poles = 0;
  for (const Coedge& coedge : coedges_of(model.faces[0].loops)) poles += edge_of(model, coedge).is_degenerate ? 1 : 0;
  return poles;
}

TopoDS_Shape torus(double radius, double tube) {
  return BRepBuilderAPI_MakeFace(new Geom_ToroidalSurface(gp_Ax3(), radius, tube), 1e-7).Shape();
}

/// About z, from the meridian's direction `start` on.
TopoDS_Shape turned_circle(double radius, double tube, const gp_Dir& start) {
  const gp_Ax2 about(gp_Pnt(radius, 0, 0), gp_Dir(0, -1, 0), start);
  return BRepBuilderAPI_MakeFace(new Geom_SurfaceOfRevolution(new Geom_Circle(about, tube), gp_Ax1()), 1e-7).Shape();
}

TEST(BetweenPoles, ATorusWhoseHoleIsAPointIsOpenedThere) {
  EXPECT_EQ(poles_of(test::model_of(torus(10, 10))), 2);
  for (const gp_Dir& start : {gp_Dir(1, 0, 0), gp_Dir(-1, 0, 0), gp_Dir(0.6, 0, 0.8)}) {
    const Model model = test::model_of(turned_circle(10, 10, start));
    EXPECT_EQ(poles_of(model), 2);
    EXPECT_TRUE(std::ranges::any_of(model.vertices, [](const Vec3& x) { return norm(x) < 1e-9; }));
  }
}

TEST(BetweenPoles, ATorusWithAHoleStays) {
  EXPECT_EQ(poles_of(test::model_of(torus(10, 9.999))), 0);
  EXPECT_EQ(poles_of(test::model_of(turned_circle(10, 9.999, {1, 0, 0}))), 0);
}

}  // namespace
}  // namespace paver
