// Models from memory, in every format, and the members of compounds.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BinTools.hxx>
#include <BinTools_ShapeSet.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <atomic>
#include <gp_Ax1.hxx>
#include <sstream>
#include <thread>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"
#include "support/folders.h"

namespace paver {
namespace {

using test::compound;

CadModel read(const std::string& bytes, const std::string& name = "the shape") {
  Progress progress;
  return read_bytes(bytes, name, progress);
}

/// As FreeCAD's exportBinary lays it out: the set, then three integers.
std::string freecad_binary(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BinTools_ShapeSet set;
  int place = set.Add(shape);
  set.Write(out);
  BinTools::PutInteger(out, place);
  BinTools::PutInteger(out, set.Locations().Index(shape.Location()));
  BinTools::PutInteger(out, static_cast<int>(shape.Orientation()));
  return out.str();
}

std::string opencascade_binary(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BinTools::Write(shape, out);
  return out.str();
}

std::string text(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out);
  return out.str();
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double x) {
  gp_Trsf shift, turn;
  shift.SetTranslation(gp_Vec(x, 0, 0));
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)), 0.3);
  return shape.Moved(TopLoc_Location(shift) * TopLoc_Location(turn));
}

gp_Pnt middle(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape, properties);
  return properties.CentreOfMass();
}

TEST(ReadBytes, ReadsEveryBrepFormatWithPlacementOrientationAndOrder) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape(), rod = BRepPrimAPI_MakeCylinder(2, 9).Shape();
  for (const TopoDS_Shape& shape : {box, moved(box, 5), TopoDS_Shape(compound({moved(box, 1), moved(rod, -7), rod})),
                                    moved(box, 5).Reversed(), moved(compound({box, moved(rod, 3)}), 8)}) {
    for (const std::string& bytes : {freecad_binary(shape), opencascade_binary(shape), text(shape)}) {
      CadModel model = read(bytes);
      EXPECT_EQ(model.report.format, "BREP");
      EXPECT_EQ(model.report.file, "the shape");
      const TopoDS_Shape& got = model.shape->shape;
      EXPECT_EQ(got.ShapeType(), shape.ShapeType());
      EXPECT_EQ(got.Orientation(), shape.Orientation());
      TopTools_IndexedMapOfShape wanted_faces, faces;
      TopExp::MapShapes(shape, TopAbs_FACE, wanted_faces);
      TopExp::MapShapes(got, TopAbs_FACE, faces);
      ASSERT_EQ(faces.Extent(), wanted_faces.Extent());
      for (int i = 1; i <= faces.Extent(); ++i)
        EXPECT_LT(middle(faces(i)).Distance(middle(wanted_faces(i))), 1e-9) << i;
    }
  }
}

TEST(ReadBytes, ReadsExamplesLikeTheirFiles) {
  for (const char* name : {"box.step", "conesphere_one_face.brep"}) {
    std::string path = test::examples_folder() / name;
    Progress progress;
    CadModel file = read_file(path, progress), bytes = read(test::read_text(path));
    EXPECT_EQ(file.report.file, path);
    EXPECT_EQ(file.report.format, bytes.report.format);
    EXPECT_EQ(file.report.unit, bytes.report.unit);
    EXPECT_EQ(file.shape->labels, bytes.shape->labels);
    EXPECT_EQ(read_file(path, progress, "Body").report.file, "Body");
  }
}

TEST(ReadBytes, TakesLabelsForFacesAndCallsPartsByThem) {
  const TopoDS_Shape boxes = compound({BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), 9, 9, 9).Shape(),
                                       BRepPrimAPI_MakeBox(gp_Pnt(9, 0, 0), 9, 9, 9).Shape(),
                                       BRepPrimAPI_MakeBox(gp_Pnt(0, 50, 0), 9, 9, 9).Shape()});
  std::vector<std::string> labels(18);
  for (std::size_t f = 0; f < 12; ++f) labels[f] = (f < 6 ? "A b/Face" : "C/Face") + std::to_string(f % 6 + 1);
  Progress progress;
  Options options;
  options.size = 5;
  const MeshResult result = mesh_model(read_bytes(text(boxes), "boxes", progress, labels), options, progress);
  EXPECT_EQ(result.face_names[7], "C/Face2");
  EXPECT_EQ(result.face_names[17], "Face18");
  EXPECT_EQ(result.face_names[18], "A b/Face2 + C/Face1");
  EXPECT_EQ(result.report.faces[18].name, "Face2 + Face7");
  EXPECT_EQ(result.report.components, (std::vector<std::vector<std::string>>{{"A b", "C"}, {"Solid3"}}));
  EXPECT_EQ(result.report.faces[7].back, std::vector<std::string>{"C"});
}

TEST(ReadBytes, NeverCrashesOnDamagedBinaryShapes) {
  std::string good = freecad_binary(moved(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), 4));
  auto code_of = [](const std::string& bytes) {
    try {
      read(bytes);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("'the shape'"), std::string::npos) << error.what();
      return error.code();
    }
    return ErrorCode::cancelled;
  };
  for (std::size_t length = 40; length < good.size(); length += 61)
    EXPECT_EQ(code_of(good.substr(0, length)), ErrorCode::damaged_file) << length;
  for (std::size_t integer : {12, 8, 4}) {
    for (char value : {'\x7f', '\xff'}) {
      std::string bad = good;
      for (std::size_t i = 0; i < 4; ++i) bad[good.size() - integer + i] = value;
      EXPECT_EQ(code_of(bad), ErrorCode::damaged_file) << integer;
    }
  }
  EXPECT_EQ(code_of("nonsense"), ErrorCode::not_a_cad_file);
  EXPECT_EQ(code_of(""), ErrorCode::not_a_cad_file);
  EXPECT_EQ(code_of(freecad_binary(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)).Shape())), ErrorCode::no_faces);
}

TEST(ReadBytes, WorksInManyThreadsAtOnce) {
  std::string step = test::read_text(test::examples_folder() / "box_cylinder.step");
  std::string brep = freecad_binary(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
  std::atomic<int> read_well = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 3; ++k)
        read_well += read(i % 2 ? step : brep).report.unit == (i % 2 ? "millimetre" : "mm (as written)");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read_well, 12) << read(step).report.unit;
}

TEST(ModelParts, NumberThePartsOfEachMember) {
  TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape(), rod = BRepPrimAPI_MakeCylinder(2, 9).Shape();
  TopExp_Explorer faces(box, TopAbs_FACE);
  std::vector<ModelPart> parts = model_parts(read(freecad_binary(compound({box, rod, faces.Current()}))));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].faces, (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(parts[0].edges.size(), 12u);
  EXPECT_EQ(parts[1].faces, (std::vector<int>{6, 7, 8}));
  EXPECT_EQ(parts[1].edges, (std::vector<int>{12, 13, 14}));
  EXPECT_EQ(parts[0].vertices.size(), 8u);
  EXPECT_EQ(parts[1].vertices, (std::vector<int>{8, 9}));
  EXPECT_EQ(parts[0].solids, (std::vector<int>{0}));
  EXPECT_EQ(parts[1].solids, (std::vector<int>{1}));
  EXPECT_TRUE(parts[2].solids.empty());
  EXPECT_EQ(parts[2].faces, (std::vector<int>{0})) << "a face that two members share has one number";
  EXPECT_EQ(model_parts(read(freecad_binary(box))).size(), 1u);
}

}  // namespace
}  // namespace paver
