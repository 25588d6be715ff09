// What the readers of STEP and IGES leave out, or take otherwise than it is meant, is told with its number in the file.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "brep/occt_impl.h"
#include "brep/reading/read_shape.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"
#include "paver/mesher.h"

namespace paver {
namespace {

using testing::Test;

class ReaderLosses : public Test {
 protected:
  std::string step_of(const TopoDS_Shape& shape) {
    test::write_step(shape, path_);
    return test::read_text(path_);
  }

  std::string box() { return step_of(BRepPrimAPI_MakeBox(10, 20, 30).Shape()); }

  std::vector<std::string> unread(const std::string& text) {
    test::write_text(path_, text);
    Progress progress;
    report_ = {};
    read_shape(path_, report_, progress);
    return report_.unread;
  }

  std::string verdict_of(const std::string& text) {
    test::write_text(path_, text);
    Options options;
    options.size = 5;
    Progress progress;
    return verdict(mesh_file(path_, options, progress).report);
  }

  /// "#12", the number of the first entity whose text has `what`.
  static std::string number_of(const std::string& text, const std::string& what) {
    const std::size_t at = text.find(what), hash = text.rfind('#', at);
    return text.substr(hash, text.find(' ', hash) - hash);
  }

  static void replace(std::string& text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    text.replace(at, what.size(), by);
  }

  static void add(std::string& text, const std::string& entities) { replace(text, "DATA;", "DATA;\n" + entities); }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("model.step");
  ModelReport report_;
};

TEST_F(ReaderLosses, NoneInCleanFiles) {
  EXPECT_TRUE(unread(box()).empty());
  EXPECT_TRUE(report_.open_solids.empty());
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(20, 20, 2).Shape(), rod = BRepPrimAPI_MakeCylinder(4, 30).Shape();
  EXPECT_TRUE(unread(step_of(BRepAlgoAPI_Cut(plate, rod).Shape())).empty());
  EXPECT_TRUE(unread(step_of(test::compound({plate, rod}))).empty());
}

// Lines of drawings and of dimensions, planes that a shape was constructed with.
TEST_F(ReaderLosses, NoneOfWhatStandsBesideShapes) {
  std::string text = box();
  const std::string axes = number_of(text, "AXIS2_PLACEMENT_3D"),
                    context = number_of(text, "( GEOMETRIC_REPRESENTATION_CONTEXT(3)");
  add(text, "#9000 = DRAUGHTING_MODEL('',(#9001)," + context +
                ");\n#9001 = ANNOTATION_CURVE_OCCURRENCE('',(),#9002);\n#9002 = GEOMETRIC_CURVE_SET('',(#9003));\n"
                "#9003 = POLYLINE('',(#9004,#9005));\n#9004 = CARTESIAN_POINT('',(0.,0.,0.));\n"
                "#9005 = CARTESIAN_POINT('',(9.,0.,0.));\n#9006 = CONSTRUCTIVE_GEOMETRY_REPRESENTATION('',(#9007)," +
                context + ");\n#9007 = GEOMETRIC_SET('',(#9008));\n#9008 = PLANE(''," + axes +
                ");\n#9009 = SHAPE_DIMENSION_REPRESENTATION('',(#9010),#9011);\n"
                "#9010 = DESCRIPTIVE_REPRESENTATION_ITEM('','');\n#9011 = REPRESENTATION_CONTEXT('','');");
  EXPECT_EQ(unread(text), std::vector<std::string>{});
}

// The hole of a plate would be filled without a word.
TEST_F(ReaderLosses, ALoopWhoseCurveCannotBeMade) {
  const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-10, -10, 0), 20, 20, 2).Shape();
  std::string text = step_of(BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(4, 30).Shape()).Shape());
  const std::string circle = number_of(text, "CIRCLE('',");
  const std::size_t at = text.find(circle + " = CIRCLE");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, text.find(';', at) - at, circle + " = COMPOSITE_CURVE('',(),.F.)");
  ASSERT_EQ(unread(text), std::vector<std::string>{circle + " CompositeCurve"});
  EXPECT_NE(verdict_of(text), "sound");
}

TEST_F(ReaderLosses, ABodyThatNothingLists) {
  std::string text = box();
  add(text,
      "#9001 = OPEN_SHELL('',(#9002));\n#9002 = ADVANCED_FACE('',(),#9003,.T.);\n#9003 = PLANE('',#9004);\n"
      "#9004 = AXIS2_PLACEMENT_3D('',#9005,$,$);\n#9005 = CARTESIAN_POINT('',(0.,0.,0.));");
  EXPECT_EQ(unread(text), std::vector<std::string>{"#9001 OpenShell"});
}

TEST_F(ReaderLosses, EntitiesThatAreNotThere) {
  std::string text = box();
  add(text, "#9001 = PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,(#9002));");
  const std::vector<std::string> labels = unread(text);
  ASSERT_FALSE(labels.empty());
  EXPECT_EQ(labels.front(), "#9002 (not there)");
}

TEST_F(ReaderLosses, ItemsOfKindsThatAreNotKnown) {
  std::string text = box();
  const std::string solid = number_of(text, "MANIFOLD_SOLID_BREP"), items = "," + solid + ")";
  replace(text, items, "," + solid + ",#9001)");
  add(text, "#9001 = A_SOLID_OF_TOMORROW('',#9002);\n#9002 = CARTESIAN_POINT('',(0.,0.,0.));");
  const std::vector<std::string> labels = unread(text);
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_NE(labels[0].find("(items)"), std::string::npos);
  EXPECT_EQ(report_.format, "STEP");
}

TEST_F(ReaderLosses, NoneOfNotesOfKindsThatAreNotKnown) {
  std::string text = box();
  const std::string part = number_of(text, "PRODUCT_DEFINITION_SHAPE"),
                    context = number_of(text, "GEOMETRIC_REPRESENTATION_CONTEXT(3)");
  add(text,
      "#9001 = A_NOTE_OF_TOMORROW('',(#9002));\n#9002 = CARTESIAN_POINT('',(0.,0.,0.));\n"
      "#9003 = SHAPE_REPRESENTATION('',(#9001)," +
          context + ");\n#9004 = SHAPE_ASPECT('',''," + part +
          ",.F.);\n"
          "#9005 = PROPERTY_DEFINITION('','',#9004);\n#9006 = SHAPE_DEFINITION_REPRESENTATION(#9005,#9003);");
  EXPECT_EQ(unread(text), std::vector<std::string>{});
  EXPECT_EQ(verdict_of(text), "sound");
}

TEST_F(ReaderLosses, PartsOfOtherFiles) {
  std::string text = box();
  const std::string product = number_of(text, "PRODUCT_CONTEXT"),
                    definition = number_of(text, "PRODUCT_DEFINITION_CONTEXT");
  add(text, "#9001 = PRODUCT('wing','wing','',(" + product +
                "));\n#9002 = PRODUCT_DEFINITION_FORMATION('','',#9001);\n"
                "#9003 = PRODUCT_DEFINITION('design','',#9002," +
                definition +
                ");\n#9004 = DOCUMENT_TYPE('geometry');\n"
                "#9005 = DOCUMENT_FILE('wing.step','','',#9004,'',$);\n#9006 = "
                "APPLIED_DOCUMENT_REFERENCE(#9005,'',(#9003));");
  EXPECT_EQ(unread(text), std::vector<std::string>{"'wing.step' (another file)"});
  EXPECT_EQ(verdict_of(text), "doubtful");
}

// The kernel takes an inch without a factor, and two units, for millimetres.
TEST_F(ReaderLosses, UnitsThatAreNotAsStated) {
  const std::string millimetre = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );";
  std::string inch = box(), chain = inch;
  replace(inch, millimetre,
          "( CONVERSION_BASED_UNIT('INCH',$) LENGTH_UNIT() NAMED_UNIT(#9002) );\n"
          "#9002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);");
  ASSERT_EQ(unread(inch).size(), 1U);
  EXPECT_NE(report_.unread[0].find("(unit of length)"), std::string::npos);
  replace(chain, millimetre,
          "( CONVERSION_BASED_UNIT('FOOT',#9004) LENGTH_UNIT() NAMED_UNIT(#9002) );\n"
          "#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9003);\n"
          "#9002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n"
          "#9004 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#9005);\n"
          "#9005 = ( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9002) );\n#9003 = " +
              millimetre);
  ASSERT_EQ(unread(chain).size(), 1U);
  EXPECT_NE(report_.unread[0].find("(unit of length)"), std::string::npos);
}

// The second axis of a mirror image looks the other way: the kernel turns the part instead.
TEST_F(ReaderLosses, PositionsWithAScaleOrAMirrorImage) {
  const auto mapped = [&](const std::string& scale, const std::string& second_axis) {
    std::string text = box();
    const std::string solid = number_of(text, "MANIFOLD_SOLID_BREP"), axes = number_of(text, "AXIS2_PLACEMENT_3D"),
                      context = number_of(text, "( GEOMETRIC_REPRESENTATION_CONTEXT(3)"),
                      before = "ADVANCED_BREP_SHAPE_REPRESENTATION('',(" + axes + "," + solid + ")";
    replace(text, before, "SHAPE_REPRESENTATION('',(" + axes + ",#9000)");
    add(text, "#9000 = MAPPED_ITEM('',#9001,#9003);\n#9001 = REPRESENTATION_MAP(" + axes +
                  ",#9002);\n#9002 = ADVANCED_BREP_SHAPE_REPRESENTATION('',(" + axes + "," + solid + ")," + context +
                  ");\n#9003 = CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',#9004,#9005,#9007," + scale +
                  ",#9006);\n#9004 = DIRECTION('',(1.,0.,0.));\n#9005 = DIRECTION('',(0.," + second_axis +
                  ",0.));\n#9006 = DIRECTION('',(0.,0.,1.));\n#9007 = CARTESIAN_POINT('',(100.,0.,0.));");
    return unread(text);
  };
  const std::vector<std::string> told{"#9000 MappedItem (position)"};
  EXPECT_TRUE(mapped("1.", "1.").empty());
  EXPECT_EQ(mapped("2.", "1."), told);
  EXPECT_EQ(mapped("$", "-1."), told);
}

// As exported with colours: the part is read once, where the assembly has it.
TEST_F(ReaderLosses, PartsThatAreMappedForTheirColoursAlone) {
  std::string text = box();
  const std::string axes = number_of(text, "AXIS2_PLACEMENT_3D"),
                    part = number_of(text, "ADVANCED_BREP_SHAPE_REPRESENTATION"),
                    context = number_of(text, "( GEOMETRIC_REPRESENTATION_CONTEXT(3)");
  const auto mapped_by = [&](const std::string& representation) {
    std::string whole = text;
    add(whole, "#9000 = MAPPED_ITEM('',#9001," + axes + ");\n#9001 = REPRESENTATION_MAP(" + axes + "," + part +
                   ");\n#9002 = " + representation + "('',(#9000," + axes + ")," + context + ");");
    return unread(whole);
  };
  EXPECT_TRUE(mapped_by("DRAUGHTING_MODEL").empty());
  EXPECT_EQ(mapped_by("SHAPE_REPRESENTATION"), std::vector<std::string>{"#9000 MappedItem"});
}

TEST_F(ReaderLosses, SolidsThatAreOpen) {
  std::string text = box();
  const std::string solid = number_of(text, "MANIFOLD_SOLID_BREP");
  const std::size_t faces = text.find("CLOSED_SHELL('',(#"), first = text.find('#', faces),
                    comma = text.find(',', first);
  text.erase(first, comma + 1 - first);
  unread(text);
  EXPECT_EQ(report_.open_solids, std::vector<std::string>{solid + " ManifoldSolidBrep"});
  EXPECT_EQ(verdict_of(text), "doubtful");
}

TEST_F(ReaderLosses, SolidsOfOtherFilesThatAreOpen) {
  BRep_Builder builder;
  TopoDS_Shell shell;
  TopoDS_Solid solid;
  builder.MakeShell(shell);
  builder.MakeSolid(solid);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 20, 30).Shape();
  TopExp_Explorer face(box, TopAbs_FACE);
  for (face.Next(); face.More(); face.Next()) builder.Add(shell, face.Current());
  builder.Add(solid, shell);
  EXPECT_EQ(test::model_of(solid).report.open_solids, std::vector<std::string>{"Solid1"});
  EXPECT_TRUE(test::model_of(shell).report.open_solids.empty());
  EXPECT_TRUE(test::model_of(box).report.open_solids.empty());
}

TEST_F(ReaderLosses, FacesOfTrianglesOnly) {
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face);
  Handle(Poly_Triangulation) triangles = new Poly_Triangulation(3, 1, false);
  for (int i = 1; i <= 3; ++i) triangles->SetNode(i, gp_Pnt(i % 2, i / 2, 0));
  triangles->SetTriangle(1, Poly_Triangle(1, 2, 3));
  builder.UpdateFace(face, triangles);
  path_ = folder_.file("triangles.brep");
  BRepTools::Write(test::compound({face, BRepPrimAPI_MakeBox(10, 20, 30).Shape()}), path_.c_str());
  const std::string text = test::read_text(path_);
  EXPECT_EQ(unread(text), std::vector<std::string>{"Face1 (triangles only)"});
  EXPECT_EQ(verdict_of(text), "doubtful");
}

TEST_F(ReaderLosses, UnitAndScaleOfAnIgesModel) {
  path_ = folder_.file("model.igs");
  const auto written = [&](double scale, const char* unit) {
    QuietMessages quiet;
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 1);
    writer.AddShape(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
    writer.ComputeModel();
    IGESData_GlobalSection header = writer.Model()->GlobalSection();
    header.SetScale(scale);
    if (unit) {
      header.SetUnitFlag(3);
      header.SetUnitName(new TCollection_HAsciiString(unit));
    }
    writer.Model()->SetGlobalSection(header);
    writer.Write(path_.c_str());
    return test::read_text(path_);
  };
  EXPECT_TRUE(unread(written(1, nullptr)).empty());
  EXPECT_EQ(unread(written(0.5, nullptr)), std::vector<std::string>{"scale of the model"});
  EXPECT_EQ(unread(written(1, "FURLONG")), std::vector<std::string>{"unit of length"});
}

}  // namespace
}  // namespace paver
