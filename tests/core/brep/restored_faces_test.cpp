// Bodies whose files have neither periodic edges nor poles in their loops, as many programs write them: which side of a
// loop a face is on is told by the direction of its edges alone.
#include <gtest/gtest.h>

#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_GTransform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <IGESBasic_HArray1OfHArray1OfIGESEntity.hxx>
#include <IGESBasic_HArray1OfHArray1OfInteger.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_HArray1OfIGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_Loop.hxx>
#include <IGESSolid_Shell.hxx>
#include <Interface_InterfaceModel.hxx>
#include <StepGeom_ToroidalSurface.hxx>
#include <StepShape_AdvancedFace.hxx>
#include <StepShape_FaceBound.hxx>
#include <TColStd_HArray1OfInteger.hxx>
#include <TopoDS_Compound.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <gp_GTrsf.hxx>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"

namespace paver {
namespace {

using test::area_of;

/// Each loop without periodic edges and poles, but those of cylinders, of which two loops would come.
TopoDS_Shape without_periodic_edges(const TopoDS_Shape& shape) {
  BRepTools_ReShape change;
  BRep_Builder builder;
  for (const TopoDS_Face& any : faces_of(shape)) {
    const TopoDS_Face face = forward(any);
    if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Cylinder) continue;
    TopoDS_Face plain = TopoDS::Face(face.EmptyCopied());
    builder.NaturalRestriction(plain, false);
    bool is_other = false;
    for (const TopoDS_Wire& wire : wires_of(face)) {
      TopoDS_Wire rest;
      builder.MakeWire(rest);
      int edges = 0;
      for (const TopoDS_Edge& edge : paver::edges_of(wire)) {
        const bool is_kept = !BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face);
        is_other |= !is_kept;
        if (is_kept) builder.Add(rest, edge), ++edges;
      }
      rest.Closed(true);
      if (edges > 0) builder.Add(plain, rest);
    }
    if (is_other) change.Replace(face, plain);
  }
  return change.Apply(shape);
}

constexpr int trimmed_surfaces = 0, solids = 1;  // as IGESControl_Writer has them

void write_iges(const TopoDS_Shape& shape, const std::string& path, int mode) {
  QuietMessages quiet;
  IGESControl_Controller::Init();
  IGESControl_Writer writer("MM", mode);
  writer.AddShape(shape);
  writer.ComputeModel();
  writer.Write(path.c_str());
}

void expect_right_side(const TopoDS_Shape& shape) {
  const test::TemporaryFolder folder;
  for (const bool is_step : {true, false}) {
    const std::string path = folder.file(is_step ? "model.step" : "model.igs");
    const TopoDS_Shape written = without_periodic_edges(shape);
    is_step ? test::write_step(written, path) : write_iges(written, path, solids);
    ModelReport report;
    Progress progress;
    const std::shared_ptr<Shape> read = read_shape(path, report, progress);
    test::Alone alone(progress);
    const Model model = build_model(*read, {}, {}, progress, alone);
    double area = 0;
    for (const Face& face : model.faces) {
      area += face.area;
      EXPECT_EQ(face.fault, "");
    }
    EXPECT_NEAR(area, area_of(shape), 1e-4 * area_of(shape)) << path;
    EXPECT_EQ(model.faces.size(), faces_of(shape).size()) << path;
  }
}

TopoDS_Shape rod(gp_Pnt from, gp_Dir along, double radius) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, along), radius, 100).Shape();
}

TEST(RestoredFaces, BallsWithAHoleAreNotTheDiscThatItCutsOut) {
  expect_right_side(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(50).Shape(), rod({0, 0, 0}, {0, 1, 0}, 8)).Shape());
  const TopoDS_Shape corner = BRepPrimAPI_MakeBox(gp_Pnt{-90, 10, 5}, 80, 80, 20).Shape();
  expect_right_side(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(50).Shape(), corner).Shape());
}

TEST(RestoredFaces, NorAreToriOnes) {
  expect_right_side(BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(40, 15).Shape(), rod({-40, 0, 0}, {0, 0, 1}, 8)).Shape());
}

/// A copy whose edges have splines as curves.
TopoDS_Face with_splines(const TopoDS_Face& face) {
  const TopoDS_Face copy = TopoDS::Face(BRepBuilderAPI_Copy(face).Shape());
  for (const TopoDS_Edge& edge : paver::edges_of(copy)) {
    if (BRep_Tool::Degenerated(edge)) continue;
    double first = 0, last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    const Handle(Geom_TrimmedCurve) piece = new Geom_TrimmedCurve(curve, first, last);
    BRep_Builder().UpdateEdge(edge, GeomConvert::CurveToBSplineCurve(piece), BRep_Tool::Tolerance(edge));
  }
  return copy;
}

// A loop through both poles, where its images jump.
TEST(RestoredFaces, SegmentsOfBallsAreTheSideThatTheLoopTells) {
  for (const double turn : {0.0, 0.5 * M_PI, M_PI, 1.5 * M_PI}) {
    SCOPED_TRACE(turn);
    const gp_Ax2 place({0, 0, 0}, {0, 0, 1}, {0, 1, 0});
    const TopoDS_Shape wedge = BRepAlgoAPI_Common(
        BRepPrimAPI_MakeSphere(place, 50).Shape(),
        BRepPrimAPI_MakeBox(gp_Ax2({0, 0, -90}, {0, 0, 1}, {std::cos(turn), std::sin(turn), 0}), 90, 90, 180).Shape());
    const TopoDS_Shape segment =
        BRepAlgoAPI_Cut(wedge, rod({0, 0, 0}, {std::cos(turn), std::sin(turn), 0}, 15)).Shape();
    TopoDS_Compound both;
    BRep_Builder builder;
    builder.MakeCompound(both);
    builder.Add(both, BRepPrimAPI_MakeBox(gp_Pnt{70, 0, 0}, 5, 5, 5).Shape());
    for (const TopoDS_Face& face : faces_of(segment))
      if (BRepAdaptor_Surface(face).GetType() == GeomAbs_Sphere) builder.Add(both, with_splines(face));
    expect_right_side(both);
  }
}

TEST(RestoredFaces, ConesWithAHoleStayOneFace) {
  const TopoDS_Shape cone = BRepPrimAPI_MakeCone(50, 0, 80).Shape();
  expect_right_side(BRepAlgoAPI_Cut(cone, rod({0, 0, 20}, {-0.3, 1, 0}, 6)).Shape());
}

TEST(RestoredFaces, WhatWasReadRightStays) {
  expect_right_side(BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(50).Shape(), rod({0, 0, 0}, {0, 0, 1}, 8)).Shape());
  expect_right_side(BRepAlgoAPI_Cut(rod({0, 0, 0}, {0, 0, 1}, 40), rod({0, 0, 50}, {1, 0.2, 0}, 8)).Shape());
}

/// As the loop is walked from the other side, without images.
void turn(const Handle(IGESSolid_Loop) & loop) {
  const int edges = loop->NbEdges();
  const Handle(TColStd_HArray1OfInteger) edge_type = new TColStd_HArray1OfInteger(1, edges, 0),
                                         index = new TColStd_HArray1OfInteger(1, edges),
                                         orientation = new TColStd_HArray1OfInteger(1, edges),
                                         images = new TColStd_HArray1OfInteger(1, edges, 0);
  const Handle(IGESData_HArray1OfIGESEntity) lists = new IGESData_HArray1OfIGESEntity(1, edges);
  for (int i = 1; i <= edges; ++i) {
    const int from = edges + 1 - i;
    lists->SetValue(i, loop->Edge(from));
    index->SetValue(i, loop->ListIndex(from));
    orientation->SetValue(i, !loop->Orientation(from));
  }
  loop->Init(edge_type, lists, index, orientation, images, new IGESBasic_HArray1OfHArray1OfInteger(1, edges),
             new IGESBasic_HArray1OfHArray1OfIGESEntity(1, edges));
}

// Some writers walk the loops of faces that look against their surfaces' normals as these are seen from outside.
TEST(RestoredFaces, LoopsOfFacesAgainstTheirSurfacesMayBeWalkedFromOutside) {
  TopoDS_Shape grooved = BRepPrimAPI_MakeBox(gp_Pnt{-70, -70, -30}, gp_Pnt{70, 70, 0}).Shape();
  for (const double side : {-1.0, 1.0}) {
    const gp_Ax2 place({0, 0, 0}, {0, 0, 1}, {side, 0, 0});
    grooved = BRepAlgoAPI_Cut(grooved, BRepPrimAPI_MakeTorus(place, 40, 15, M_PI).Shape()).Shape();
    grooved = BRepAlgoAPI_Fuse(grooved, BRepPrimAPI_MakeCylinder(gp_Ax2({60 * side, 60, 0}, {0, 0, 1}), 5, 10).Shape())
                  .Shape();
  }
  const test::TemporaryFolder folder;
  const std::string path = folder.file("model.igs");
  write_iges(grooved, path, solids);
  IGESControl_Reader written;
  written.ReadFile(path.c_str());
  const Handle(IGESData_IGESModel) entities = written.IGESModel();
  int turned = 0;
  for (int i = 1; i <= entities->NbEntities(); ++i)
    if (const auto shell = Handle(IGESSolid_Shell)::DownCast(entities->Entity(i)); !shell.IsNull())
      for (int k = 1; k <= shell->NbFaces(); ++k)
        for (int m = 1; !shell->Orientation(k) && m <= shell->Face(k)->NbLoops(); ++m, ++turned)
          turn(shell->Face(k)->Loop(m));
  ASSERT_GT(turned, 1);
  IGESControl_Writer(entities).Write(path.c_str());
  ModelReport report;
  Progress progress;
  const std::shared_ptr<Shape> read = read_shape(path, report, progress);
  test::Alone alone(progress);
  const Model model = build_model(*read, {}, {}, progress, alone);
  EXPECT_NEAR(model.report.area, area_of(grooved), 1e-5 * area_of(grooved));
  EXPECT_EQ(model.report.free_edges, 0);
}

/// As STEP, with the loops of tori walked the other way round than the edges beside them.
void write_turned_tori(const TopoDS_Shape& shape, const std::string& path) {
  QuietMessages quiet;
  STEPControl_Controller::Init();
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const Handle(Interface_InterfaceModel) entities = writer.WS()->Model();
  int turned = 0;
  for (int i = 1; i <= entities->NbEntities(); ++i) {
    const auto face = Handle(StepShape_AdvancedFace)::DownCast(entities->Value(i));
    if (face.IsNull() || !face->FaceGeometry()->IsKind(STANDARD_TYPE(StepGeom_ToroidalSurface))) continue;
    for (int k = 1; k <= face->NbBounds(); ++k)
      face->BoundsValue(k)->SetOrientation(!face->BoundsValue(k)->Orientation());
    ++turned;
  }
  ASSERT_GT(turned, 0);
  writer.Write(path.c_str());
}

// Some writers turn the loops of fillets, and of tori only.
TEST(RestoredFaces, LoopsThatTheFileContradictsTellNoSide) {
  const TopoDS_Shape rod = BRepPrimAPI_MakeCylinder(3, 20).Shape(), ball = BRepPrimAPI_MakeSphere(8).Shape();
  for (const TopoDS_Shape& shape : {rod, BRepAlgoAPI_Fuse(ball, rod).Shape()}) {
    BRepFilletAPI_MakeFillet fillet(shape);
    for (const TopoDS_Edge& edge : edges_of(shape))
      if (!BRep_Tool::Degenerated(edge) && shapes_of(edge, TopAbs_VERTEX).Extent() == 1) fillet.Add(1, edge);
    const TopoDS_Shape rounded = fillet.Shape();
    const test::TemporaryFolder folder;
    write_turned_tori(rounded, folder.file("model.step"));
    ModelReport report;
    Progress progress;
    const std::shared_ptr<Shape> read = read_shape(folder.file("model.step"), report, progress);
    test::Alone alone(progress);
    const Model model = build_model(*read, {}, {}, progress, alone);
    EXPECT_NEAR(model.report.area, area_of(rounded), 1e-4 * area_of(rounded));
    EXPECT_EQ(model.report.free_edges, 0);
  }
}

/// The torus without a box that goes through it askew, and how IGES has its round face as a trimmed surface.
void expect_same_torus(double radius, gp_Pnt corner, gp_Dir along, bool is_alone) {
  SCOPED_TRACE(radius);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Ax2(corner, along, gp_Dir(0.3, 0.9, 0.2)), 11, 13, 9).Shape();
  TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(10, radius).Shape(), box).Shape();
  if (is_alone) {
    const std::vector<TopoDS_Face> faces = faces_of(shape);
    shape = *std::ranges::find(faces, GeomAbs_Torus,
                               [](const TopoDS_Face& face) { return BRepAdaptor_Surface(face).GetType(); });
  }
  const test::TemporaryFolder folder;
  write_iges(shape, folder.file("model.igs"), trimmed_surfaces);
  ModelReport report;
  Progress progress;
  const std::shared_ptr<Shape> read = read_shape(folder.file("model.igs"), report, progress);
  test::Alone alone(progress);
  const Model model = build_model(*read, {}, {}, progress, alone), drawn = test::model_of(shape);
  EXPECT_NEAR(model.report.area, area_of(shape), 1e-5 * area_of(shape));
  EXPECT_EQ(model.report.free_edges, drawn.report.free_edges);
}

TEST(RestoredFaces, ToriAreThePiecesThatTheImagesTell) {
  for (const bool is_alone : {false, true})
    for (const double radius : {3.0, 7.0}) {
      expect_same_torus(radius, {7, -4, -3}, {0.2, -0.4, 0.9}, is_alone);
      expect_same_torus(radius, {-9, 5, -4}, {-0.5, 0.1, 0.8}, is_alone);
      expect_same_torus(radius, {-6, -12, -5}, {0.1, 0.4, 0.7}, is_alone);
      expect_same_torus(radius, {4, 4, -6}, {0.6, 0.1, 0.8}, is_alone);
    }
}

/// The shape with a loop of no edges on a face, first or last.
TopoDS_Shape with_empty_loop(const TopoDS_Shape& shape, const TopoDS_Face& face, bool is_first) {
  BRep_Builder builder;
  TopoDS_Wire empty;
  builder.MakeWire(empty);
  TopoDS_Face other = TopoDS::Face(face.EmptyCopied());
  builder.NaturalRestriction(other, false);
  if (is_first) builder.Add(other, empty);
  for (const TopoDS_Wire& wire : wires_of(face)) builder.Add(other, wire);
  if (!is_first) builder.Add(other, empty);
  BRepTools_ReShape change;
  change.Replace(face, other);
  return change.Apply(shape);
}

// Booleans leave such loops, and the kernel writes others for them.
TEST(RestoredFaces, LoopsWithoutEdgesAreNone) {
  const TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(50).Shape(), rod({0, 0, 0}, {0, 1, 0}, 8)).Shape();
  for (const TopoDS_Face& face : faces_of(shape))
    for (const bool is_first : {true, false}) {
      const test::TemporaryFolder folder;
      write_iges(with_empty_loop(shape, face, is_first), folder.file("model.igs"), trimmed_surfaces);
      ModelReport report;
      Progress progress;
      const std::shared_ptr<Shape> read = read_shape(folder.file("model.igs"), report, progress);
      test::Alone alone(progress);
      const Model model = build_model(*read, {}, {}, progress, alone);
      EXPECT_NEAR(model.report.area, area_of(shape), 1e-4 * area_of(shape)) << is_first;
      EXPECT_EQ(model.report.free_edges, 0) << is_first;
      EXPECT_TRUE(report.unread.empty()) << is_first;
      for (const Face& made : model.faces) EXPECT_EQ(made.fault, "") << is_first;
    }
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, Vec3 by) {
  gp_GTrsf scale;
  for (const auto& [axis, factor] : {std::pair{1, by.x}, {2, by.y}, {3, by.z}}) scale.SetValue(axis, axis, factor);
  return BRepBuilderAPI_GTransform(shape, scale, true).Shape();
}

// The kernel's own images of edges through a pole are wrong after such a transformation, and tolerances as large.
TEST(RestoredFaces, BodiesStretchedOneWayKeepWhatLiesAboutTheirPoles) {
  for (const auto& [radius, by] : {std::pair{8.0, Vec3{1, 1.5, 2}},
                                   {7.758932293726081, {1.2159593517818386, 2.892514508661983, 2.731315067711764}}}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(30, 20, 15).Shape(),
                       ball = BRepPrimAPI_MakeSphere(gp_Pnt(30, 10, radius), radius).Shape();
    const TopoDS_Shape stretched = scaled(BRepAlgoAPI_Fuse(box, ball).Shape(), by);
    const double area = test::model_of(BRepAlgoAPI_Fuse(scaled(box, by), scaled(ball, by)).Shape()).report.area;
    const test::TemporaryFolder folder;
    BRepTools::Write(stretched, folder.file("model.brep").c_str());
    write_iges(stretched, folder.file("model.igs"), trimmed_surfaces);
    for (const char* name : {"model.brep", "model.igs"}) {
      ModelReport report;
      Progress progress;
      const std::shared_ptr<Shape> read = read_shape(folder.file(name), report, progress);
      test::Alone alone(progress);
      const Model model = build_model(*read, {}, {}, progress, alone);
      EXPECT_NEAR(model.report.area, area, 1e-4 * area) << name;
      EXPECT_LT(model.report.curve_distance, 1e-3) << name;
      EXPECT_EQ(model.report.free_edges, 0) << name;
    }
  }
}

}  // namespace
}  // namespace paver
