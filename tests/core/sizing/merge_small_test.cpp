// What is small against the target length is merged, and nothing else.
#include "sizing/merging/merge_small.h"

#include <gtest/gtest.h>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>

#include "brep/occt_shapes_impl.h"
#include "core/brep/step_files.h"
#include "support/fragments.h"
#include "support/has_node.h"
#include "support/report_of.h"

namespace paver {
namespace {

TopoDS_Shape box_with_fillets(double radius) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 10, 10).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next())
    fillet.Add(radius, TopoDS::Edge(edge.Current()));
  return fillet.Shape();
}

TopoDS_Face polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& point : points) wire.Add(point);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

TopoDS_Face disc_of_segments(int count) {
  std::vector<gp_Pnt> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.emplace_back(5 * std::cos(angle), 5 * std::sin(angle), 0);
  }
  return polygon(points);
}

/// Of 10 x 10 x 8, its first side divided at the widths given.
TopoDS_Shape block_in_strips(const std::vector<double>& widths) {
  std::vector<gp_Pnt> points{{0, 0, 0}};
  for (double width : widths) points.emplace_back(points.back().X() + width, 0, 0);
  points.emplace_back(10, 0, 0);
  points.emplace_back(10, 10, 0);
  points.emplace_back(0, 10, 0);
  return BRepPrimAPI_MakePrism(polygon(points), gp_Vec(0, 0, 8)).Shape();
}

MeshResult unmerged(const TopoDS_Shape& shape, double size) {
  Options options;
  options.size = size;
  options.merge = 0;
  return test::mesh_of(shape, options);
}

long faces_of(const MeshResult& result, FaceStatus status) {
  return std::count_if(result.report.faces.begin(), result.report.faces.end(),
                       [status](const FaceReport& face) { return face.status == status; });
}

/// Shortest line of the mesh on an edge, between its ends.
double shortest_line(const SurfaceMesh& mesh) {
  const auto stride = static_cast<std::size_t>(mesh.order) + 1;
  double shortest = INFINITY;
  for (std::size_t i = 0; i + 1 < mesh.lines.size(); i += stride)
    shortest = std::min(shortest, norm(mesh.nodes[mesh.lines[i]] - mesh.nodes[mesh.lines[i + 1]]));
  return shortest;
}

/// A block whose edge is cut off by a face of `width`, all else at right angles.
TopoDS_Shape block_with_hairline(double width) {
  return BRepPrimAPI_MakePrism(polygon({{width, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, width, 0}}),
                               gp_Vec(0, 0, 8))
      .Shape();
}

TEST(MergeSmall, HairlinesGoWhateverTheAngles) {
  for (const double width : {1e-6, 2e-5}) {
    SCOPED_TRACE(width);
    const MeshResult result = test::mesh_of(block_with_hairline(width), 2);
    ASSERT_EQ(result.report.merges.size(), 1u);
    EXPECT_EQ(result.report.merges[0].kind, MergeKind::face);
    EXPECT_TRUE(result.report.quality.watertight);
    EXPECT_STREQ(verdict(result.report), "sound");
    EXPECT_EQ(result.report.quality.quads, 4 * 5 * 4 + 2 * 5 * 5);
  }
  EXPECT_TRUE(test::mesh_of(block_with_hairline(0.01), 2).report.merges.empty());
}

// As narrow ones are opposite each other what lies within a twentieth of the target length; that may be most of a side.
TEST(MergeSmall, HairlinesGoWhereOneOfTheirSidesIsDivided) {
  TopoDS_Shape post = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, -40), gp_Pnt(2, 2, 0)).Shape();
  for (const double y : {0.0, 0.9})
    post = BRepAlgoAPI_Fuse(post, BRepPrimAPI_MakeBox(gp_Pnt(0, y, 0), gp_Pnt(1.9995, y + (y > 0 ? 1.1 : 0.9), 40)));
  const MeshResult result = test::mesh_of(post, 1e6);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_TRUE(
      std::ranges::any_of(result.report.merges, [](const Merge& merge) { return merge.kind == MergeKind::face; }));
  EXPECT_GT(result.report.quality.sj_all.min, 0.3);
}

// Without its rims both sides of a foil had one border, and at low frequencies the same elements.
TEST(MergeSmall, TheRimsOfAPlateStay) {
  for (const double size : {1e6, 50.0}) {
    const MeshResult result = test::mesh_of(BRepPrimAPI_MakeBox(300, 200, 0.017).Shape(), size);
    EXPECT_TRUE(result.report.merges.empty());
    EXPECT_STREQ(verdict(result.report), "sound");
    EXPECT_EQ(result.report.quality.triangles, 0);
  }
}

TEST(MergeSmall, ABoxWithSmallFilletsIsABox) {
  const MeshResult result = test::mesh_of(box_with_fillets(0.05), 2);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_TRUE(result.report.quality.watertight);
  EXPECT_EQ(faces_of(result, FaceStatus::meshed), 6);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 20);
  EXPECT_EQ(result.report.merges.size(), 20U);
  EXPECT_EQ(result.report.quality.quads, 150);
  EXPECT_EQ(result.report.quality.triangles, 0);
  EXPECT_LT(result.report.quality.distance.largest, 0.05);
  EXPECT_GT(shortest_line(result.mesh), 1.5);
}

/// Of 14 x 24 x 8: its upright edges rounded by 1 mm, then the edges of its top and its bottom by half of that.
TopoDS_Shape rounded_block() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(14, 24, 8).Shape();
  BRepFilletAPI_MakeFillet upright(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
    if (std::abs(curve.Line().Direction().Z()) > 0.5) upright.Add(1, TopoDS::Edge(edge.Current()));
  }
  BRepFilletAPI_MakeFillet rims(upright.Shape());
  for (TopExp_Explorer edge(upright.Shape(), TopAbs_EDGE); edge.More(); edge.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
    if (curve.GetType() == GeomAbs_Line && std::abs(curve.Line().Direction().Z()) < 0.5)
      rims.Add(0.5, TopoDS::Edge(edge.Current()));
  }
  return rims.Shape();
}

TEST(MergeSmall, ABandGoesToOneSide) {
  const MeshResult result = test::mesh_of(rounded_block(), 1000);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_TRUE(result.report.quality.watertight);
  EXPECT_EQ(result.report.merges.size(), 16U) << "two bands of eight faces";
}

/// Flat, with a hole; about it a ring whose inner rim begins on the other side.
TopoDS_Shape plate_with_ring() {
  auto circle = [](double radius, double along) {
    return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(), gp_Dir(0, 0, 1), gp_Dir(along, 0, 0)), radius)).Edge();
  };
  const TopoDS_Edge outer = circle(4.75, 1), middle = circle(0.525, 1), inner = circle(0.35, -1);
  auto between = [](const TopoDS_Edge& one, const TopoDS_Edge& other) {
    BRepBuilderAPI_MakeFace face(gp_Pln(), BRepBuilderAPI_MakeWire(one).Wire());
    face.Add(TopoDS::Wire(BRepBuilderAPI_MakeWire(other).Wire().Reversed()));
    return face.Face();
  };
  TopoDS_Shell shell;
  BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, between(outer, middle));
  builder.Add(shell, between(middle, inner));
  return shell;
}

TEST(MergeSmall, ARingGoesWhereverItsRimsBegin) {
  for (double size : {1.0, 3.0, 10.0, 1000.0}) {
    const MeshResult result = test::mesh_of(plate_with_ring(), size);
    EXPECT_STREQ(verdict(result.report), "sound") << size;
    EXPECT_NEAR(result.report.quality.mesh_area, std::numbers::pi * (4.75 * 4.75 - 0.35 * 0.35), 1) << size;
  }
}

/// A package whose upright edges are rounded by 0.06 mm, and then those about its top: facets at its corners stay, and
/// strips end at them.
TEST(MergeSmall, StripsStayWhereWhatTheyEndAtDoes) {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(7, 12.2, 2.6).Shape();
  for (const bool is_top : {false, true}) {
    BRepFilletAPI_MakeFillet fillet(shape);
    const auto edges = shapes_of(shape, TopAbs_EDGE);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
      const double from = BRep_Tool::Pnt(TopExp::FirstVertex(edge)).Z(),
                   to = BRep_Tool::Pnt(TopExp::LastVertex(edge)).Z();
      if (is_top ? std::min(from, to) > 2.5 : std::abs(from - to) > 1) fillet.Add(is_top ? 0.049 : 0.06, edge);
    }
    shape = fillet.Shape();
  }
  for (const double h : {1.8, 2.9}) {
    const MeshResult result = test::mesh_of(shape, h);
    EXPECT_STREQ(verdict(result.report), "sound") << h;
    EXPECT_GT(result.report.quality.sj_all.min, 0.05) << h;
  }
}

TEST(MergeSmall, LargeFilletsStay) {
  const MeshResult result = test::mesh_of(box_with_fillets(0.5), 2);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
  EXPECT_TRUE(result.report.merges.empty());
}

TEST(MergeSmall, OffKeepsEverything) {
  const MeshResult result = unmerged(box_with_fillets(0.05), 2);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
  EXPECT_TRUE(result.report.merges.empty());
  EXPECT_EQ(faces_of(result, FaceStatus::meshed), 26);
}

TEST(MergeSmall, ShortSegmentsAreDividedAsOne) {
  const MeshResult result = test::mesh_of(disc_of_segments(300), 2);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_LT(result.report.quality.quads, 50);
  EXPECT_EQ(result.report.quality.triangles, 0);
  EXPECT_GT(shortest_line(result.mesh), 1);
  EXPECT_LT(result.report.quality.distance.largest, 0.01);
  EXPECT_GT(unmerged(disc_of_segments(300), 2).report.quality.quads, 300);
}

TEST(MergeSmall, AnEdgeThatIsNotShortKeepsItsEnds) {
  std::vector<gp_Pnt> points{{0, 0, 0}, {5, 0, 0}, {5.05, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  const MeshResult result = test::mesh_of(polygon(points), 2);
  EXPECT_TRUE(result.report.merges.empty());
  for (const double x : {5.0, 5.05}) EXPECT_TRUE(test::has_node(result.mesh, {x, 0, 0}, 1e-9));
}

TEST(MergeSmall, ManyPiecesOfAStraightEdgeAreOne) {
  std::vector<gp_Pnt> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(0.5 * i, 0, 0);  // a quarter of the target length each
  for (const gp_Pnt& corner : {gp_Pnt(10, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(0, 10, 0)}) points.push_back(corner);
  const MeshResult result = test::mesh_of(polygon(points), 2);
  EXPECT_EQ(result.report.quality.quads, 25);
  EXPECT_EQ(result.report.quality.triangles, 0);
  EXPECT_EQ(result.report.merges.size(), 19U);
}

TEST(MergeSmall, AStripGoesToAWideNeighbour) {
  const MeshResult result = test::mesh_of(block_in_strips({0.04, 0.01, 4.95}), 2);
  // The end of the second, on the edges of the block, is too short to matter; that of the first is not.
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 1);
  ASSERT_EQ(result.report.merges.size(), 1U);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_TRUE(result.report.quality.watertight);
}

TEST(MergeSmall, AThinPlateKeepsItsRim) {
  const MeshResult result = test::mesh_of(BRepPrimAPI_MakeBox(10, 10, 0.03).Shape(), 2);
  EXPECT_TRUE(result.report.merges.empty());
  EXPECT_EQ(faces_of(result, FaceStatus::meshed), 6);
}

/// A pipe that turns by 90 degrees, within little more than its width: its inner side has no length.
TopoDS_Shape pipe_with_elbow() {
  const gp_Dir x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const TopoDS_Shape elbow = BRepPrimAPI_MakeTorus(gp_Ax2({0, 0, 0}, y, z), 0.9, 0.45, std::numbers::pi / 2).Shape();
  const TopoDS_Shape along = BRepPrimAPI_MakeCylinder(gp_Ax2({0, 0, 0.9}, gp_Dir(-1, 0, 0)), 0.45, 30).Shape();
  const TopoDS_Shape down = BRepPrimAPI_MakeCylinder(gp_Ax2({0.9, 0, 0}, gp_Dir(0, 0, -1)), 0.45, 30).Shape();
  return BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(elbow, along).Shape(), down).Shape();
}

TEST(MergeSmall, APipeKeepsItsElbow) {
  const MeshResult result = test::mesh_of(pipe_with_elbow(), 1e6);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
  EXPECT_EQ(faces_of(result, FaceStatus::failed), 0);
  EXPECT_STREQ(verdict(result.report), "sound");
}

/// A plate with a groove; its ends are tiny against the plate, its sides thin and at right angles to all about them.
TEST(MergeSmall, AThinFaceDoesNotLoseItsEnds) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(100, 60, 5).Shape();
  const TopoDS_Shape groove = BRepPrimAPI_MakeBox(gp_Pnt(40, 20, 4.6), gp_Pnt(62, 21.2, 6)).Shape();
  const MeshResult result = test::mesh_of(BRepAlgoAPI_Cut(plate, groove).Shape(), 1e6);
  EXPECT_EQ(faces_of(result, FaceStatus::failed), 0);
}

/// A ring with a web whose flat end lies in it by 0.018 mm: at both of its faces two pieces of 1 mm that have two
/// sides. As points they would move all about them by 1 mm, and of each two one would stay.
TEST(MergeSmall, SlenderFacesGiveWayToASideRatherThanToAPoint) {
  const TopoDS_Shape ring =
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(30, 40).Shape(), BRepPrimAPI_MakeCylinder(28, 40).Shape()).Shape();
  const TopoDS_Shape web = BRepPrimAPI_MakeBox(gp_Pnt(1.5, -1, 0), gp_Pnt(28, 1, 40)).Shape();
  const MeshResult result = test::mesh_of(BRepAlgoAPI_Fuse(ring, web).Shape(), 12);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 4);
  for (const Merge& merge : result.report.merges) EXPECT_LT(merge.size, 0.02) << merge.name;
  EXPECT_STREQ(verdict(result.report), "sound");
}

/// A plate with a round notch in its border, and in its plane half a ring about that and a pad about the ring. The pad
/// is tiny: one place for all its border would draw the ring across the notch.
TopoDS_Shape plate_with_pad_at_notch() {
  auto arc = [](double radius) {
    return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2({0, 0, 0}, gp_Dir(0, 0, 1)), radius), 0, std::numbers::pi).Edge();
  };
  BRepBuilderAPI_MakeWire border(arc(0.4));
  const std::vector<gp_Pnt> corners{{-0.4, 0, 0}, {-50, 0, 0}, {-50, 60, 0}, {50, 60, 0}, {50, 0, 0}, {0.4, 0, 0}};
  for (std::size_t i = 1; i < corners.size(); ++i)
    border.Add(BRepBuilderAPI_MakeEdge(corners[i - 1], corners[i]).Edge());
  const double y = std::sqrt(0.55 * 0.55 - 0.25);
  BRepBuilderAPI_MakePolygon pad;
  for (const gp_Pnt& point : {gp_Pnt(0.5, y, 0), gp_Pnt(0.5, 1.3, 0), gp_Pnt(-0.5, 1.3, 0), gp_Pnt(-0.5, y, 0)})
    pad.Add(point);
  return test::fragments_of({BRepBuilderAPI_MakeFace(border.Wire()).Face(), arc(0.55), pad.Wire()});
}

TEST(MergeSmall, ATinyFaceStaysWhereItsNeighbourIsNarrow) {
  const MeshResult result = test::mesh_of(plate_with_pad_at_notch(), 1e6);
  EXPECT_EQ(result.report.faces.size(), 3U);
  EXPECT_EQ(faces_of(result, FaceStatus::failed), 0);
}

/// A trace on a board that ends in a bar across it, `deep` inside: its sides run on along the bar's there.
TopoDS_Shape trace_into_bar(double deep) {
  const double end = 3 + deep;
  return test::fragments_of({polygon({{-15, -15, 0}, {15, -15, 0}, {15, 15, 0}, {-15, 15, 0}}),
                             polygon({{-9, -0.5, 0}, {end, -0.5, 0}, {end, 0.5, 0}, {-9, 0.5, 0}}),
                             polygon({{3, 0.5, 0}, {3, 2, 0}, {5, 2, 0}, {5, -2, 0}, {3, -2, 0}, {3, -0.5, 0}})});
}

// An edge of 1.5 with a bend at a third of its length was a bulging side, 0.16 off.
TEST(MergeSmall, AShortEdgeStaysWhereAnotherWouldBendAndIsLittleLonger) {
  const MeshResult result = test::mesh_of(trace_into_bar(0.5), 1e6);
  EXPECT_TRUE(result.report.merges.empty());
  EXPECT_LT(result.report.quality.distance.largest, 1e-9);
  EXPECT_FALSE(test::mesh_of(trace_into_bar(0.1), 1e6).report.merges.empty());
}

/// A block with a rounded edge; on its top a post of 3 mm that reaches beyond the line where that begins.
TopoDS_Shape block_with_post(double beyond) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(100, 60, 20).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edge.Current()));
    const gp_Pnt middle = curve.Value(0.5 * (curve.FirstParameter() + curve.LastParameter()));
    if (middle.Distance(gp_Pnt(50, 60, 20)) < 1e-6) fillet.Add(3, TopoDS::Edge(edge.Current()));
  }
  const gp_Ax2 axis(gp_Pnt(50, 57 - 1.5 + beyond, 17), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Fuse(fillet.Shape(), BRepPrimAPI_MakeCylinder(axis, 1.5, 8).Shape()).Shape();
}

TEST(MergeSmall, AShortEdgeThatBendsStaysWhereAnotherIsLittleLonger) {
  for (double beyond : {0.05, 0.08, 0.3}) {
    const MeshResult result = test::mesh_of(block_with_post(beyond), 1000);
    EXPECT_STREQ(verdict(result.report), "sound") << beyond;
    EXPECT_LE(result.report.merges.size(), 1U) << beyond;
  }
}

TopoDS_Shape blunt_cone(double blunt, double angle = 2 * std::numbers::pi) {
  return BRepPrimAPI_MakeCone(10, blunt, 30, angle).Shape();
}

TEST(MergeSmall, ABluntNoseEndsInAPole) {
  const MeshResult pointed = test::mesh_of(blunt_cone(0), 3);
  for (double blunt : {1e-6, 1e-4, 1e-2}) {
    const MeshResult result = test::mesh_of(blunt_cone(blunt), 3);
    EXPECT_STREQ(verdict(result.report), "sound") << blunt;
    EXPECT_NEAR(result.report.quality.quads, pointed.report.quality.quads, 6);
    EXPECT_EQ(result.report.quality.triangles, 0);
    EXPECT_GT(result.report.quality.sj_all.min, pointed.report.quality.sj_all.min - 0.01);
    ASSERT_EQ(result.report.merges.size(), 1U);
    EXPECT_EQ(faces_of(result, FaceStatus::merged), 1);
  }
}

TEST(MergeSmall, ABluntNoseOfAPartOfATurnDoesToo) {
  for (double angle : {0.5, 1.0, 1.5})
    for (double blunt : {1e-4, 1e-2}) {
      const MeshResult result = test::mesh_of(blunt_cone(blunt, angle * std::numbers::pi), 3);
      EXPECT_STREQ(verdict(result.report), "sound") << blunt;
      EXPECT_EQ(result.report.quality.triangles, 0);
      EXPECT_GT(result.report.quality.sj_all.min, 0.3);
      EXPECT_EQ(faces_of(result, FaceStatus::merged), 1);
    }
}

/// A solid that has no face where the cone is cut off.
TopoDS_Solid open_cone(double blunt) {
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  BRep_Builder builder;
  builder.MakeShell(shell);
  builder.MakeSolid(solid);
  for (TopExp_Explorer face(blunt_cone(blunt), TopAbs_FACE); face.More(); face.Next())
    if (std::abs(test::area_of(face.Current()) - std::numbers::pi * blunt * blunt) > 1e-3 * blunt * blunt)
      builder.Add(shell, face.Current());
  builder.Add(solid, shell);
  return solid;
}

TEST(MergeSmall, ASolidThatIsClosedByItIsNotOpen) {
  const RunReport closed = test::mesh_of(open_cone(5e-5), 3).report;
  EXPECT_EQ(closed.model.faces, 2);
  EXPECT_EQ(closed.model.free_edges, 0);
  EXPECT_STREQ(verdict(closed), "sound");
  const RunReport open = test::mesh_of(open_cone(0.5), 3).report;
  EXPECT_EQ(open.model.free_edges, 1);
  EXPECT_EQ(open.model.open_solids, std::vector<std::string>{"Solid1"});
  EXPECT_STREQ(verdict(open), "doubtful");
}

TEST(MergeSmall, AConeThatIsBluntAgainstItsElementsStays) {
  const MeshResult result = test::mesh_of(blunt_cone(0.1), 3);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
}

// Two cones, tip on tip: they meet in one node, and do not run through each other.
TEST(MergeSmall, ANeckEndsInOneNode) {
  const TopoDS_Shape up = BRepPrimAPI_MakeCone(gp_Ax2({0, 0, 30}, {0, 0, 1}), 1e-3, 10, 30).Shape();
  const MeshResult result = test::mesh_of(BRepAlgoAPI_Fuse(blunt_cone(1e-3), up).Shape(), 3);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_GT(result.report.quality.sj_all.min, 0.3);
}

TEST(MergeSmall, HolesThatNoMeshCouldShowGo) {
  const TopoDS_Shape plate = polygon({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}});
  const gp_Ax2 at({7, 9, -1}, {0, 0, 1});
  const auto quads = [&](double radius) {
    return test::mesh_of(BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(at, radius, 2).Shape()).Shape(), 2)
        .report.quality.quads;
  };
  EXPECT_EQ(quads(5e-5), 100);
  EXPECT_GT(quads(1e-2), 100);
}

TEST(MergeSmall, AHoleStaysWhereAProbeGoesThrough) {
  const TopoDS_Shape plate = polygon({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}});
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2({7, 9, -1}, {0, 0, 1}), 5e-5, 2).Shape();
  const TopoDS_Shape wire = BRepBuilderAPI_MakeEdge(gp_Pnt{7, 9, -5}, gp_Pnt{7, 9, 5}).Shape();
  const MeshResult result = test::mesh_of(test::compound({BRepAlgoAPI_Cut(plate, drill).Shape(), wire}), 2);
  EXPECT_TRUE(result.report.merges.empty());
  EXPECT_EQ(result.report.components.size(), 2U);
}

// A cone whose tip is a hole's rim stays at the plate.
TEST(MergeSmall, AHoleStaysWhereAnotherFaceGoesOn) {
  const TopoDS_Shape plate = polygon({{-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0}});
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(1e-3, 8, 10).Shape();
  const TopoDS_Shape wall = TopExp_Explorer(cone, TopAbs_FACE).Current();
  const MeshResult result = test::mesh_of(test::compound({BRepAlgoAPI_Cut(plate, cone).Shape(), wall}), 2);
  EXPECT_STREQ(verdict(result.report), "sound");
  EXPECT_EQ(result.report.components.size(), 1U);
}

// It does not widen from either end.
TEST(MergeSmall, AThinRodKeepsItsEnds) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(0.01, 30).Shape();
  EXPECT_EQ(faces_of(test::mesh_of(rod, 3), FaceStatus::merged), 0);
}

TEST(MergeSmall, ATinyBodyStays) {
  const MeshResult result = test::mesh_of(BRepPrimAPI_MakeBox(0.01, 0.01, 0.01).Shape(), 2);
  EXPECT_EQ(result.report.quality.quads, 6);
}

TopoDS_Shape board_with(std::initializer_list<TopoDS_Shape> sheets) {
  std::vector<TopoDS_Shape> parts{BRepPrimAPI_MakeBox(40, 40, 2).Shape()};
  parts.insert(parts.end(), sheets);
  return test::compound(parts);
}

TEST(MergeSmall, APadOnABoardStays) {
  const TopoDS_Face pad = polygon({{10, 10, 2}, {10.2, 10, 2}, {10.2, 10.2, 2}, {10, 10.2, 2}});
  const MeshResult result = test::mesh_of(board_with({pad}), 8);
  EXPECT_EQ(faces_of(result, FaceStatus::merged), 0);
  EXPECT_STREQ(verdict(result.report), "sound");
}

// The line ends at a round patch, which touches it beside the middle.
TEST(MergeSmall, WhereAPatchTouchesTheEndOfALineStaysANode) {
  const TopoDS_Face line = polygon({{19.25, 4, 2}, {20.25, 4, 2}, {20.25, 14, 2}, {19.25, 14, 2}});
  const gp_Circ rim(gp_Ax2({20, 20, 2}, gp::DZ()), 6);
  const TopoDS_Face patch =
      BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(rim)).Wire()).Face();
  for (double size : {9.0, 5.0, 1.5}) {
    const MeshResult result = test::mesh_of(board_with({line, patch}), size);
    EXPECT_STREQ(verdict(result.report), "sound") << size;
    EXPECT_TRUE(test::has_node(result.mesh, {20, 14, 2})) << size;
  }
}

TEST(MergeSmall, WhereALengthIsGivenNothingIsMerged) {
  const TopoDS_Shape shape = box_with_fillets(0.05);
  Options options;
  options.size = 2;
  options.local.push_back({"Face1", 0.1, 1, 1});
  const MeshResult result = test::mesh_of(shape, options);
  EXPECT_EQ(result.report.faces[0].status, FaceStatus::meshed);
}

TEST(MergeSmall, MergesAreListedWithPlaces) {
  const MeshResult result = test::mesh_of(box_with_fillets(0.05), 2);
  for (const Merge& merge : result.report.merges) {
    EXPECT_EQ(merge.kind, MergeKind::face);
    EXPECT_FALSE(merge.name.empty());
    EXPECT_FALSE(merge.into.empty());
    EXPECT_GT(merge.size, 0);
    EXPECT_LT(merge.size, 0.2);
  }
  EXPECT_TRUE(std::any_of(result.report.notes.begin(), result.report.notes.end(),
                          [](const std::string& note) { return note.starts_with("Merged"); }));
}

}  // namespace
}  // namespace paver
