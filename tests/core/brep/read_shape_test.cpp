// Reading: formats by content, units, names, and one clear error for every way a file can be wrong.
#include "brep/reading/read_shape.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "brep/occt_impl.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"
#include "paver/mesher.h"

namespace paver {
namespace {

using test::read_text;
using test::TemporaryFolder;
using test::write_text;

class ReadShape : public testing::Test {
 protected:
  std::string write_step() {
    std::string path = folder_.file("box.step");
    test::write_step(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), path);
    return path;
  }
  /// The same numbers, in inches: versions of the writer differ in what they make of a unit.
  std::string write_step_in_inches() {
    const std::string path = write_step(), millimetre = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) );";
    std::string text = test::read_text(path);
    const std::size_t at = text.find(millimetre);
    EXPECT_NE(at, std::string::npos);
    text.replace(at, millimetre.size(),
                 "( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9002) );\n"
                 "#9001 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9003);\n"
                 "#9002 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#9003 = " +
                     millimetre);
    write_text(path, text);
    return path;
  }
  std::string write_iges(const TopoDS_Shape& shape = BRepPrimAPI_MakeBox(10, 20, 30).Shape(), int mode = 1,
                         double resolution = 1e-7) {
    QuietMessages quiet;
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", mode);
    writer.AddShape(shape);
    writer.ComputeModel();
    IGESData_GlobalSection header = writer.Model()->GlobalSection();
    header.SetResolution(resolution);
    writer.Model()->SetGlobalSection(header);
    std::string path = folder_.file("box.igs");
    writer.Write(path.c_str());
    return path;
  }
  std::string write_brep() {
    std::string path = folder_.file("box.brep");
    BRepTools::Write(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), path.c_str());
    return path;
  }
  std::shared_ptr<Shape> read(const std::string& path) {
    Progress progress;
    report_ = {};
    return read_shape(path, report_, progress);
  }
  static int face_count(const Shape& shape) {
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape.shape, TopAbs_FACE, faces);
    return faces.Extent();
  }
  void expect_error(const std::string& path, ErrorCode code, const std::string& part) {
    try {
      read(path);
      FAIL() << "read without an error";
    } catch (const Error& error) {
      EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  }

  TemporaryFolder folder_;
  ModelReport report_;
};

TEST_F(ReadShape, ReadsEveryFormatByContentWhateverTheEnding) {
  std::string binary = folder_.file("binary");
  BinTools::Write(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), binary.c_str());
  std::pair<std::string, std::string> cases[] = {
      {write_step(), "STEP"}, {write_iges(), "IGES"}, {write_brep(), "BREP"}, {binary, "BREP"}};
  for (const auto& [path, format] : cases) {
    std::string disguised = folder_.file("model.txt");
    std::filesystem::copy_file(path, disguised, std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(face_count(*read(disguised)), 6) << format;
    EXPECT_EQ(report_.format, format);
    EXPECT_EQ(report_.file, disguised);
    EXPECT_FALSE(report_.unit.empty());
  }
}

TEST_F(ReadShape, ConvertsToMillimetresAndSaysTheUnitOfTheFile) {
  auto shape = read(write_step_in_inches());
  EXPECT_EQ(report_.unit, "INCH");
  Model model = test::model_of(shape->shape);
  EXPECT_NEAR(model.report.area, 2200 * 25.4 * 25.4, 1e-6);
  read(write_brep());
  EXPECT_EQ(report_.unit, "mm (as written)");
}

TEST_F(ReadShape, GivesFacesTheNamesOfAStepFile) {
  std::string path = write_step(), text = read_text(path);
  std::size_t at = text.find("ADVANCED_FACE('");
  ASSERT_NE(at, std::string::npos);
  text.insert(at + 15, "radome");
  write_text(path, text);
  auto shape = read(path);
  ASSERT_EQ(shape->labels.size(), 6u);
  EXPECT_EQ(std::count(shape->labels.begin(), shape->labels.end(), "radome"), 1);
  EXPECT_EQ(std::count(shape->labels.begin(), shape->labels.end(), ""), 5);
}

// Older writers put their own letters in: a name that is not UTF-8 lost one.
TEST_F(ReadShape, ReadsNamesInLettersOfWesternEurope) {
  const std::string path = write_step(), text = read_text(path);
  for (const std::string letter : {"\xC4", "\xC3\x84"}) {
    std::string named = text;
    named.insert(named.find("ADVANCED_FACE('") + 15, letter + "rger");
    write_text(path, named);
    const auto labels = read(path)->labels;
    EXPECT_EQ(std::count(labels.begin(), labels.end(), "\xC3\x84rger"), 1) << letter;
  }
}

TEST_F(ReadShape, ReadsStepFilesWithTheByteOrderMarkOfUtf8) {
  const std::string path = write_step();
  write_text(path, "\xEF\xBB\xBF" + read_text(path));
  EXPECT_EQ(face_count(*read(path)), 6);
}

// A cone's angle in degrees where the file says radians: the kernel makes nothing of that face.
TEST_F(ReadShape, TellsFacesOfStepFilesThatCannotBeRead) {
  const std::string path = write_step();
  std::string text = read_text(path);
  const std::size_t at = text.find("PLANE(''"), end = text.find(')', at);
  ASSERT_NE(end, std::string::npos);
  text.replace(end, 1, ",1.,30.)").replace(at, 5, "CONICAL_SURFACE");
  write_text(path, text);
  EXPECT_EQ(face_count(*read(path)), 5);
  ASSERT_EQ(report_.unread.size(), 1U);
  EXPECT_EQ(report_.unread[0].front(), '#');
  Options options;
  options.size = 5;
  Progress progress;
  EXPECT_STREQ(verdict(mesh_file(path, options, progress).report), "doubtful");
}

TEST_F(ReadShape, ReadsAgainAndAgain) {
  std::string step = write_step(), iges = write_iges();
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(face_count(*read(step)), 6);
    EXPECT_EQ(face_count(*read(iges)), 6);
  }
}

TEST_F(ReadShape, SaysWhatIsWrongWithAPath) {
  expect_error(folder_.file("nothing.step"), ErrorCode::file_missing, "does not exist");
  expect_error(folder_.file(""), ErrorCode::file_missing, "is a folder");
  expect_error("/dev/null", ErrorCode::file_missing, "not a file");
  std::string path = write_brep();
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (geteuid() != 0) expect_error(path, ErrorCode::file_missing, "permissions");
}

TEST_F(ReadShape, SaysWhatAFileIsNot) {
  std::string path = folder_.file("file");
  write_text(path, "");
  expect_error(path, ErrorCode::not_a_cad_file, "is empty");
  write_text(path, " \n \n");
  expect_error(path, ErrorCode::not_a_cad_file, "is empty");
  write_text(path, "solid cube\nfacet normal 0 0 1\n");
  expect_error(path, ErrorCode::not_a_cad_file, "not a STEP, IGES or BREP file");
  write_text(path, std::string("PK\x03\x04", 4) + "Document.xml");
  expect_error(path, ErrorCode::not_a_cad_file, "FreeCAD document");
  write_text(path, "\x1f\x8b rest");
  expect_error(path, ErrorCode::not_a_cad_file, "gzip");
}

TEST_F(ReadShape, RefusesFilesThatAreCutOffAnywhere) {
  for (const std::string& path : {write_step(), write_iges(), write_brep()}) {
    std::string text = read_text(path), cut = folder_.file("cut");
    for (int i = 2; i < 20; ++i) {
      write_text(cut, text.substr(0, text.size() * static_cast<std::size_t>(i) / 20));
      EXPECT_THROW(read(cut), Error) << path << " at " << i << "/20";
    }
  }
}

TEST_F(ReadShape, NamesTheDamagedEntityOfAStepFile) {
  std::string path = write_step(), text = read_text(path);
  std::size_t at = text.find("CARTESIAN_POINT(''");
  std::size_t open = text.find('(', at + 16);
  text.replace(open, text.find(')', open) - open + 1, "#99999");
  write_text(path, text);
  expect_error(path, ErrorCode::damaged_file, "entity #");
}

// The kernel's reader would look for others in memory that it has not set.
TEST_F(ReadShape, RefusesAStepFileWithAnEntityTwice) {
  std::string path = write_step(), text = read_text(path);
  const std::size_t at = text.find("#7 =");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 4, "#1 =");
  write_text(path, text);
  expect_error(path, ErrorCode::damaged_file, "entity #1 (");
}

TEST_F(ReadShape, RefusesFilesWithoutFacesAndWires) {
  std::string path = folder_.file("point.brep");
  BRepTools::Write(BRepBuilderAPI_MakeVertex(gp_Pnt(0, 0, 0)).Vertex(), path.c_str());
  expect_error(path, ErrorCode::no_faces, "has no faces and no wires");
}

// An angle of 2 pi with nine digits leaves the surface open by 2e-10 of the radius.
TEST_F(ReadShape, LargeCylindersOfIgesFilesAreClosed) {
  for (double radius : {500.0, 600.0, 5000.0})
    for (int mode : {0, 1}) {  // loose faces, solid
      Options options;
      options.size = 0.2 * radius;
      Progress progress;
      const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(radius, 2 * radius).Shape();
      const RunReport report = mesh_file(write_iges(cylinder, mode, 1e-5), options, progress).report;
      EXPECT_STREQ(verdict(report), "sound") << radius << " " << mode;
      EXPECT_TRUE(report.quality.watertight) << radius << " " << mode;
    }
}

TEST_F(ReadShape, StopsWhenCancelled) {
  std::string path = write_step();
  Progress progress;
  progress.cancel();
  EXPECT_THROW(read_shape(path, report_, progress), Error);
}

TEST_F(ReadShape, CreditsItsStageAndPrintsNothing) {
  std::string path = write_step();
  Progress progress;
  testing::internal::CaptureStdout();
  read_shape(path, report_, progress);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(progress.stage(), Stage::read);
  EXPECT_DOUBLE_EQ(progress.fraction(), 1);
}

}  // namespace
}  // namespace paver
