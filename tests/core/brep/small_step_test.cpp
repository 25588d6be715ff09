// What reading STEP does to pieces of small size, and to ogives, from file to mesh.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp.hxx>

#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

RunReport report_from_step(const TopoDS_Shape& shape, double size) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("model.step");
  test::write_step(shape, path);
  Options options;
  options.size = size;
  Progress progress;
  return mesh_file(path, options, progress).report;
}

TopoDS_Edge arc(const gp_Pnt& from, const gp_Pnt& by, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(from, by, to).Value());
}

/// A cone with a round cap, 37 times `scale` high.
TopoDS_Shape capped_cone(double scale) {
  const gp_Pnt apex(0, 0, 0), rim(10 * scale, 0, 30 * scale), top(0, 0, 37 * scale);
  const gp_Pnt side(6.3 * scale, 0, 35 * scale);
  BRepBuilderAPI_MakeWire profile(BRepBuilderAPI_MakeEdge(apex, rim), arc(rim, side, top));
  return BRepPrimAPI_MakeRevol(profile.Wire(), gp::OZ()).Shape();
}

// The kernel's reader takes what is shorter than a millimetre for noise.
TEST(SmallStep, BodiesOfMicrometresKeepTheirCaps) {
  const double area = test::report_of(capped_cone(1), 4).quality.mesh_area;
  for (double scale : {1.0, 0.03, 0.001}) {
    const RunReport report = report_from_step(capped_cone(scale), 4 * scale);
    EXPECT_STREQ(verdict(report), "sound") << scale;
    EXPECT_TRUE(report.quality.watertight) << scale;
    EXPECT_NEAR(report.quality.mesh_area / (scale * scale), area, 1e-3 * area) << scale;
  }
}

// Their file has a vertex for a border, on the whole circle turned about the axis.
TEST(SmallStep, OgivesEndAtTheirPoles) {
  for (double radius : {8.0, 25.4}) {
    const TopoDS_Edge profile = arc(gp_Pnt(0, 0, -127), gp_Pnt(radius, 0, 0), gp_Pnt(0, 0, 127));
    const TopoDS_Shape ogive = BRepPrimAPI_MakeRevol(profile, gp::OZ()).Shape();
    const RunReport direct = test::report_of(ogive, 9), report = report_from_step(ogive, 9);
    EXPECT_STREQ(verdict(report), "sound") << radius;
    EXPECT_NEAR(report.quality.mesh_area, direct.quality.mesh_area, 1e-3 * direct.quality.mesh_area) << radius;
    EXPECT_EQ(report.quality.quads, direct.quality.quads) << radius;
  }
}

}  // namespace
}  // namespace paver
