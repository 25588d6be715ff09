// Rows round slim tubes that are cut open along their periodic edge.
#include "paving/closing/tube_rows.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

constexpr double bend = 40;

TopoDS_Shape pipe(double radius) { return BRepPrimAPI_MakeTorus(bend, radius, 5 * std::numbers::pi / 3).Shape(); }

/// Its upper half is cut off at one end, along twice the radius.
TopoDS_Shape pipe_with_notch(double radius) {
  const gp_Pnt low(bend - 2 * radius, -2 * radius, 0.2 * radius), high(bend + 2 * radius, 2 * radius, 4 * radius);
  return BRepAlgoAPI_Cut(pipe(radius), BRepPrimAPI_MakeBox(low, high).Shape()).Shape();
}

/// Half way, outside.
TopoDS_Shape pipe_with_hole(double radius) {
  const gp_Ax2 axis(gp_Pnt(-bend, 0, 0), gp_Dir(-1, 0.3, 0.2));
  return BRepAlgoAPI_Cut(pipe(radius), BRepPrimAPI_MakeCylinder(axis, 0.4 * radius, 10 * radius).Shape()).Shape();
}

// Some sizes had ended in an element that folds onto the periodic edge, or in two about all of the pipe.
TEST(TubeRows, APipeWithANotchOrAHoleIsMeshedAtEverySize) {
  for (const TopoDS_Shape& shape : {pipe_with_notch(1), pipe_with_hole(2)})
    for (double h : {2.0, 5.0, 8.0, 12.0, 40.0}) {
      const RunReport report = test::report_of(shape, h);
      EXPECT_STREQ(verdict(report), "sound") << h;
      EXPECT_LT(report.quality.distance.largest, 0.5) << h;
    }
}

// As many as its plain rim has, by its turn: so many elements lie at any place along it.
TEST(TubeRows, HaveAsManyColumnsAsThePlainRim) {
  const SurfaceMesh mesh = test::mesh_of(pipe_with_notch(1), 8).mesh;
  for (double place : {0.7, 0.95, 1.2, 1.45}) {  // of half a turn
    int round = 0;
    for (std::size_t q = 0; q < mesh.quads.size(); q += 9) {
      double low = INFINITY, high = -INFINITY;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 x = mesh.nodes[static_cast<std::size_t>(mesh.quads[q + k])];
        const double angle = std::atan2(-x.y, -x.x) / std::numbers::pi + 1;
        low = std::min(low, angle), high = std::max(high, angle);
      }
      if (low < place && place <= high && high - low < 1) ++round;
    }
    EXPECT_EQ(round, 6) << place;
  }
}

}  // namespace
}  // namespace paver
