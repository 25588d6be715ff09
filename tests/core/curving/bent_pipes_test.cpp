// Wires and pipe bends, whose sides are far longer than the way round them.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeTorus.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

struct Bend {
  double ring, tube, degrees, h, max_turn = 45;
};

std::ostream& operator<<(std::ostream& out, const Bend& bend) {
  return out << bend.ring << " " << bend.tube << " " << bend.degrees << " at " << bend.h << ", " << bend.max_turn;
}

class BentPipe : public testing::TestWithParam<Bend> {};

TEST_P(BentPipe, IsFollowedByItsElements) {
  const Bend& bend = GetParam();
  Options options;
  options.size = bend.h;
  options.max_turn = bend.max_turn * std::numbers::pi / 180;
  const TopoDS_Shape shape = BRepPrimAPI_MakeTorus(bend.ring, bend.tube, bend.degrees * std::numbers::pi / 180).Shape();
  const RunReport report = test::mesh_of(shape, options).report;
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.quality.triangles, 0);
  EXPECT_LT(report.quality.distance.angle, 5) << "middles beside the rows of their sides turn elements about the pipe";
  EXPECT_LT(report.quality.distance.largest, 0.02 * bend.tube);
  EXPECT_GT(report.quality.min_jacobian_ratio, 0.2);
  EXPECT_NEAR(report.quality.mesh_area, report.quality.cad_area, 0.005 * report.quality.cad_area);
}

INSTANTIATE_TEST_SUITE_P(Wires, BentPipe,
                         testing::Values(Bend{40, 2, 300, 29.691}, Bend{40, 1, 300, 19.315}, Bend{40, 2, 360, 29.691},
                                         Bend{40, 2, 300, 29.691, 30}, Bend{40, 2, 300, 29.691, 20}));
INSTANTIATE_TEST_SUITE_P(Elbows, BentPipe,
                         testing::Values(Bend{40, 6, 90, 1e6}, Bend{20, 6, 90, 1e6}, Bend{20, 6, 180, 40},
                                         Bend{12, 6, 90, 24}));

}  // namespace
}  // namespace paver
