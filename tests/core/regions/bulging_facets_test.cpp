// Where curved sides of a region would run over each other, facets are divided before it is paved.
#include "regions/bulging_facets.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <numbers>
#include <vector>

#include "support/report_of.h"

namespace paver {
namespace {

using Indices = std::vector<int>;

/// Of a circle about the origin, by degrees.
CurvedFacet arc(double radius, double from, double to, int node) {
  auto at = [&](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Vec2{radius * std::cos(angle), radius * std::sin(angle)};
  };
  return {at(from), at(0.5 * (from + to)), at(to), node, node + 1};
}

TEST(CrowdedFacets, SidesThatKeepApartAreLeft) {
  EXPECT_EQ(crowded_facets({}), Indices{});
  EXPECT_EQ(crowded_facets({arc(12, 0, 30, 0), arc(10, 30, 0, 10)}), Indices{});
}

TEST(CrowdedFacets, FacingSidesOfANarrowRingAreLeft) {
  // The inner side crosses the outer one's chord, but one quad lies between them.
  EXPECT_EQ(crowded_facets({arc(12, 0, 60, 0), arc(11.5, 60, 0, 10)}), Indices{});
}

TEST(CrowdedFacets, AChordThatAnotherSideCrossesIsDivided) {
  const CurvedFacet next{{11.3, 0.5}, {10.8, 1.6}, {10.24, 2.74}, 20, 11};
  EXPECT_EQ(crowded_facets({arc(12, 0, 60, 0), arc(10.6, 45, 15, 10), next}), Indices{0});
}

TEST(CrowdedFacets, AChordNextToANodeIsDivided) {
  const CurvedFacet step{{10.3, 6}, {9.3, 5.5}, {8.3, 5}, 10, 11};
  EXPECT_EQ(crowded_facets({step, arc(12, 0, 60, 0)}), Indices{1});
}

TEST(CrowdedFacets, OfSidesThatCrossTheOneThatBulgesMoreIs) {
  const CurvedFacet low{{0, 0.2}, {30, 0.2}, {60, 2.4}, 0, 1}, high{{60, -2.4}, {30, -0.25}, {0, -0.2}, 10, 11};
  EXPECT_EQ(crowded_facets({low, high}), Indices{0});
}

TEST(CrowdedFacets, ANarrowRingWithNotchesIsMeshedAtAnySize) {
  auto disc = [](double radius) {
    const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), radius);
    return BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle))).Shape();
  };
  TopoDS_Shape ring = BRepAlgoAPI_Cut(disc(12), disc(11)).Shape();
  ring = BRepAlgoAPI_Cut(ring, BRepPrimAPI_MakeBox(gp_Pnt(-11.5, -0.5, -1), 23, 1, 2).Shape()).Shape();
  const double area = std::numbers::pi * (144 - 121) - 1.0;
  for (const double size : {1e6, 8.0, 3.0}) {
    const RunReport report = test::report_of(ring, size);
    EXPECT_STREQ(verdict(report), "sound") << size;
    EXPECT_NEAR(report.quality.mesh_area, area, 0.02 * area) << size;
  }
}

}  // namespace
}  // namespace paver
