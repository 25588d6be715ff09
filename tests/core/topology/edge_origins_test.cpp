// Edges keep the numbers of the shape as read, whatever is sewn, divided or added.
#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRep_Builder.hxx>
#include <Geom_SphericalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>

#include "brep/occt_impl.h"
#include "core/brep/shape_files.h"
#include "paver/mesher.h"

namespace paver {
namespace {

using test::compound;
using test::model_of;

TopoDS_Face square(double x0, double x1, double y0, double y1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp::DZ()), x0, x1, y0, y1).Face();
}

double distance(Vec3 point, const TopoDS_Shape& edge) {
  BRepAdaptor_Curve curve(TopoDS::Edge(edge));
  double least = 1e300, a = curve.FirstParameter(), b = curve.LastParameter();
  for (int i = 0; i <= 2000; ++i) least = std::min(least, norm(to_vec(curve.Value(a + (b - a) * i / 2000)) - point));
  return least;
}

/// Every origin of every edge passes through the middle of that edge; all edges of the shape that faces use are found.
void expect_origins(const TopoDS_Shape& shape, const Model& model, double tolerance) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  EXPECT_EQ(model.read_edges, edges.Extent());
  std::vector<bool> is_found(static_cast<std::size_t>(edges.Extent()), false);
  for (const Edge& edge : model.edges) {
    for (int origin : edge.origins) {
      is_found[static_cast<std::size_t>(origin)] = true;
      if (!edge.curve) continue;
      EXPECT_LT(distance(edge.curve->point(0.5 * (edge.t0 + edge.t1)), edges(origin + 1)), tolerance);
    }
    if (edge.origins.empty()) continue;
    EXPECT_EQ(edge.name, "Edge" + std::to_string(edge.origins.front() + 1));
  }
  EXPECT_EQ(std::count(is_found.begin(), is_found.end(), false), 0);
}

TEST(EdgeOrigins, AreThePositionsInTheShape) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  Model model = model_of(box);
  expect_origins(box, model, 1e-3);
  for (std::size_t e = 0; e < model.edges.size(); ++e)
    EXPECT_EQ(model.edges[e].origins, std::vector<int>{static_cast<int>(e)});
}

TEST(EdgeOrigins, EdgesWithoutFacesAreWires) {
  TopoDS_Shape wire = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 5, 5), gp_Pnt(9, 9, 9)).Shape();
  Model model = model_of(compound({wire, square(0, 1, 0, 1)}));
  ASSERT_EQ(model.edges.size(), 5u);
  EXPECT_EQ(model.read_edges, 5);
  EXPECT_TRUE(model.edges[0].is_wire());
  EXPECT_FALSE(model.edges[1].is_wire());
  EXPECT_EQ(model.parts, (std::vector<std::string>{"Sheet1", "Wire1"}));
}

TEST(EdgeOrigins, SewnEdgesKnowBothNumbers) {
  TopoDS_Compound loose = compound({});
  BRep_Builder builder;
  for (TopExp_Explorer faces(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), TopAbs_FACE); faces.More(); faces.Next()) {
    Shape copy;
    std::ostringstream out;
    BRepTools::Write(faces.Current(), out);
    std::istringstream in(out.str());
    BRepTools::Read(copy.shape, in, builder);
    builder.Add(loose, copy.shape);
  }
  Model model = model_of(loose);
  ASSERT_EQ(model.edges.size(), 12u);
  EXPECT_EQ(model.read_edges, 24);
  expect_origins(loose, model, 1e-2);
  for (const Edge& edge : model.edges) EXPECT_EQ(edge.origins.size(), 2u) << edge.name;
}

TEST(EdgeOrigins, AnEdgeSewnToTwoOthersIsInPieces) {
  TopoDS_Compound tee = compound({square(0, 2, 0, 1), square(0, 1, 1, 2), square(1, 2, 1, 2)});
  Model model = model_of(tee);
  expect_origins(tee, model, 1e-2);
  long common = std::count_if(model.edges.begin(), model.edges.end(),
                              [](const Edge& edge) { return edge.origins.size() == 2 && edge.faces.size() == 2; });
  EXPECT_EQ(common, 3);
}

TEST(EdgeOrigins, BoundsThatWereMissingAreAdded) {
  BRep_Builder builder;
  TopoDS_Face ball;
  builder.MakeFace(ball, new Geom_SphericalSurface(gp_Ax3(), 1), 1e-7);
  Model model = model_of(compound({square(3, 4, 3, 4), ball}));
  EXPECT_EQ(model.read_edges, 4);
  ASSERT_EQ(model.edges.size(), 7u);
  std::vector<std::string> names;
  for (const Edge& edge : model.edges) names.push_back(edge.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Edge1", "Edge2", "Edge3", "Edge4", "Added1", "Added2", "Added3"}));
}

TEST(EdgeOrigins, LinesOfAMeshLieOnTheEdgesTheyName) {
  TopoDS_Shape wire = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 5, 5), gp_Pnt(9, 9, 9)).Shape();
  TopoDS_Compound tee = compound({wire, square(0, 2, 0, 1), square(0, 1, 1, 2), square(1, 2, 1, 2)});
  std::ostringstream out;
  BRepTools::Write(tee, out);
  Options options;
  options.size = 0.25;
  Progress progress;
  MeshResult result = mesh_model(read_bytes(out.str(), "tee", progress), options, progress);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(tee, TopAbs_EDGE, edges);
  ASSERT_EQ(result.edge_names.size(), 13u);
  EXPECT_EQ(result.edge_names[12], "Edge13");
  std::vector<int> lines(13, 0);
  auto expect_on = [&](std::size_t line, int edge) {
    ++lines[static_cast<std::size_t>(edge)];
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LT(distance(result.mesh.nodes[static_cast<std::size_t>(result.mesh.lines[3 * line + k])], edges(edge + 1)),
                2e-3);
  };
  for (std::size_t line = 0; line < result.mesh.line_edge.size(); ++line) expect_on(line, result.mesh.line_edge[line]);
  for (auto [line, edge] : result.mesh.further_edges) expect_on(static_cast<std::size_t>(line), edge);
  EXPECT_EQ(lines[0], 28) << "a wire of its own";
  for (std::size_t edge = 1; edge < 13; ++edge) EXPECT_GE(lines[edge], 4) << edge;
  EXPECT_EQ(std::count(lines.begin(), lines.end(), 8), 2) << "both long edges, one of them sewn to two short ones";
}

}  // namespace
}  // namespace paver
