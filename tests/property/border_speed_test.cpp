// Faces whose parameters run badly along a border: both derivatives the same way there, or one of them at rest, as
// lofts and revolved noses of CAD systems have them. Elements beside them are as long as elsewhere.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <functional>

#include "support/report_of.h"

namespace paver {
namespace {

/// A Bezier face with poles at place(i, j), i of `across` in u and j of `up` in v.
TopoDS_Shape bezier(int across, int up, const std::function<gp_Pnt(int, int)>& place) {
  TColgp_Array2OfPnt poles(1, across, 1, up);
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < up; ++j) poles(i + 1, j + 1) = place(i, j);
  constexpr double tolerance = 1e-6;
  return BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), tolerance).Face();
}

void expect_even(const TopoDS_Shape& face, double size) {
  const RunReport report = test::report_of(face, size);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_LT(report.quality.longest_edge, 2.3 * size);
  EXPECT_LT(report.quality.length_cv, 0.19);
}

class BorderSpeed : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Sizes, BorderSpeed, testing::Values(7.0, 3.1, 1.3));

// The second row of poles lies along the border: v starts along u, and turns off it within the face.
TEST_P(BorderSpeed, DerivativesThatRunTheSameWay) {
  expect_even(bezier(4, 3,
                     [](int i, int j) {
                       constexpr double along[] = {0, 9, 0};
                       return gp_Pnt(60 * i + along[j], j < 2 ? 0 : 120, 6 * i * (3 - i) * (j < 2 ? 1 : 0.5));
                     }),
              GetParam());
}

// ... and past the border: near one end v first leads out of the face.
TEST_P(BorderSpeed, DerivativesThatRunPastEachOther) {
  expect_even(bezier(4, 3,
                     [](int i, int j) {
                       constexpr double out[] = {0.2, 0.1, -0.05, -0.1};
                       return gp_Pnt(60 * i + 8 * (j == 1), j < 2 ? j * out[i] : 120, 0);
                     }),
              GetParam());
}

// Two columns of poles coincide: rows end at rest.
TEST_P(BorderSpeed, RowsThatEndAtRest) {
  expect_even(bezier(4, 3,
                     [](int i, int j) {
                       constexpr double along[] = {0, 100, 180, 180};
                       return gp_Pnt(along[i] + 30 * j, 70 * j, 10 * j * (2 - j));
                     }),
              GetParam());
}

}  // namespace
}  // namespace paver
