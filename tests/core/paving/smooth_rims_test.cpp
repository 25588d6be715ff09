// Short smooth rims: two of their chords are no corner of an element once sides are curved.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include "support/report_of.h"

namespace paver {
namespace {

TEST(SmoothRims, NoElementHasTwoSidesInOneLine) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(30, 100).Shape(),
                     frustum = BRepPrimAPI_MakeCone(50, 25, 80).Shape();
  for (double size : {16.5, 17.5, 18.0, 19.0, 20.0})
    EXPECT_GT(test::report_of(cylinder, size).quality.min_jacobian_ratio, 0.2) << size;
  for (double size : {13.0, 14.0, 15.0, 16.0, 17.0, 17.5})
    EXPECT_GT(test::report_of(frustum, size).quality.min_jacobian_ratio, 0.2) << size;
}

}  // namespace
}  // namespace paver
