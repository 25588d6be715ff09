// Nothing hangs on an absolute size: a model made a thousand times larger or smaller, and turned, gives about the same
// mesh. Not exactly the same: the numbers in the file are rounded.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Reader.hxx>
#include <cmath>
#include <gp_Ax1.hxx>
#include <string>

#include "support/folders.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::report_of;

TopoDS_Shape example(const std::string& name) {
  STEPControl_Reader reader;
  EXPECT_EQ(reader.ReadFile((test::examples_folder() / (name + ".step")).c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  return reader.OneShape();
}

TopoDS_Shape scaled(const TopoDS_Shape& shape, double scale) {
  gp_Trsf turn, grow;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, -1, 2)), 0.8);
  grow.SetScale(gp_Pnt(0, 0, 0), scale);
  return BRepBuilderAPI_Transform(shape, grow * turn, true).Shape();
}

class Scale : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Examples, Scale,
                         testing::Values("box_cylinder", "conesphere", "plate_nine_holes", "wavy_patch"));

TEST_P(Scale, ChangesLittle) {
  TopoDS_Shape shape = example(GetParam());
  RunReport one = report_of(shape, 8);
  ASSERT_GT(one.quality.quads, 100);
  for (double scale : {1e-3, 1e3}) {
    SCOPED_TRACE(scale);
    RunReport other = report_of(scaled(shape, scale), 8 * scale);
    const QualityReport &a = one.quality, &b = other.quality;
    EXPECT_NEAR(static_cast<double>(b.quads), static_cast<double>(a.quads), 0.08 * static_cast<double>(a.quads));
    EXPECT_NEAR(b.mesh_area / (scale * scale), a.mesh_area, 1e-4 * a.mesh_area);
    EXPECT_NEAR(b.sj_all.mean, a.sj_all.mean, 0.02);
    EXPECT_EQ(b.inverted, 0);
    EXPECT_EQ(b.border_edges == 0, a.border_edges == 0);
    for (const FaceReport& face : other.faces) EXPECT_EQ(face.status, FaceStatus::meshed) << face.name;
  }
}

}  // namespace
}  // namespace paver
