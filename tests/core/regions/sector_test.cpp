// Faces that go most of the way round a pole: rows about it, not side by side.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCone.hxx>
#include <numbers>

#include "support/report_of.h"

namespace paver {
namespace {

TEST(Sector, OfAFlatConeHasElementsOfOneLength) {
  for (double degrees : {240.0, 317.0, 345.0}) {
    const RunReport report =
        test::report_of(BRepPrimAPI_MakeCone(10, 0, 3, degrees * std::numbers::pi / 180).Shape(), 1);
    EXPECT_LT(test::longest_side(report), 1.6) << degrees;
    EXPECT_STREQ(verdict(report), "sound") << degrees;
    EXPECT_LE(report.quality.triangles, 2) << degrees;
  }
}

}  // namespace
}  // namespace paver
