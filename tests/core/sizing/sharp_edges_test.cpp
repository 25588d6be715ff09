#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <algorithm>
#include <gp_Pln.hxx>

#include "sizing/parts/find_places.h"
#include "support/report_of.h"

namespace paver {
namespace {

long count(const TopoDS_Shape& shape) {
  const std::vector<bool> sharp = find_sharp_edges(test::model_of(shape));
  return std::count(sharp.begin(), sharp.end(), true);
}

TEST(SharpEdges, AllOfABox) { EXPECT_EQ(count(BRepPrimAPI_MakeBox(3, 2, 1).Shape()), 12); }

TEST(SharpEdges, NotThoseOfARoomInABody) {
  const TopoDS_Shape room = BRepPrimAPI_MakeBox(gp_Pnt(1, 1, 1), 1, 1, 1).Shape();
  EXPECT_EQ(count(BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(3, 3, 3).Shape(), room).Shape()), 12);
}

TEST(SharpEdges, RimsOfACylinderButNotItsPeriodicEdge) { EXPECT_EQ(count(BRepPrimAPI_MakeCylinder(2, 5).Shape()), 2); }

TEST(SharpEdges, TheBorderOfASheet) { EXPECT_EQ(count(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 2, 0, 1).Face()), 4); }

TEST(SharpEdges, TheyGetShorterElements) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(-20, -20, -10), 40, 40, 10).Shape();
  const TopoDS_Shape post = BRepPrimAPI_MakeCylinder(5, 20).Shape();
  Options options;
  options.size = 4;
  options.grade_edges = 4;
  const MeshResult result = test::mesh_of(BRepAlgoAPI_Fuse(box, post).Shape(), options);
  EXPECT_STREQ(verdict(result.report), "sound");
  double rim = 0, foot = 0;
  const SurfaceMesh& mesh = result.mesh;
  for (std::size_t i = 0; i + 1 < mesh.lines.size(); i += 3) {
    const Vec3 a = mesh.nodes[mesh.lines[i]], b = mesh.nodes[mesh.lines[i + 1]];
    if (std::abs(a.z - 20) < 1e-6 && std::abs(b.z - 20) < 1e-6) rim = std::max(rim, norm(b - a));
    const bool is_foot = std::abs(a.z) < 1e-6 && std::abs(std::hypot(a.x, a.y) - 5) < 1e-6 && std::abs(b.z) < 1e-6;
    if (is_foot) foot = std::max(foot, norm(b - a));
  }
  EXPECT_LT(rim, 1.3);
  EXPECT_GT(foot, 2.5);
}

}  // namespace
}  // namespace paver
