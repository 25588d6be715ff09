// What touches a round body along a line that ends at a pole: fins and wires.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "core/brep/shape_files.h"
#include "support/report_of.h"

namespace paver {
namespace {

using test::compound;

constexpr double radius = 10, turned = 0.7;  // of the ball, and from its seam

TopoDS_Shape ball() { return BRepPrimAPI_MakeSphere(radius); }

/// In the plane through the axis at this angle: from the axis to 15, from the equator to 15, outside of the ball.
TopoDS_Shape fin(double angle) {
  const gp_Dir out(std::cos(angle), std::sin(angle), 0), normal(std::sin(angle), -std::cos(angle), 0);
  return BRepAlgoAPI_Cut(BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({0, 0, 0}, normal, out)), 0, 15, 0, 15), ball());
}

double quarter_nodes(double size) { return std::ceil(0.5 * M_PI * radius / size); }

TEST(PoleContact, AFinAlongAMeridianIsConnected) {
  for (double size : {20.0, 3.0, 1.0})
    for (double angle : {turned, 2.5, -1.0}) {
      SCOPED_TRACE(testing::Message() << "size " << size << ", angle " << angle);
      const RunReport report = test::report_of(compound({ball(), fin(angle)}), size);
      EXPECT_STREQ(verdict(report), "sound");
      EXPECT_EQ(report.components.size(), 1u);
      for (const std::string& note : report.notes) EXPECT_TRUE(note.starts_with("Elements repaired")) << note;
      EXPECT_GE(report.quality.nonmanifold_edges, quarter_nodes(size) - 1);
    }
}

TEST(PoleContact, SeveralFinsMeetAtThePole) {
  const RunReport report = test::report_of(compound({ball(), fin(turned), fin(turned + 2), fin(turned + 4)}), 2);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_EQ(report.components.size(), 1u);
  EXPECT_GE(report.quality.nonmanifold_edges, 3 * (quarter_nodes(2) - 1));
}

TEST(PoleContact, AWireOnABallUpToItsPoleHasLines) {
  const gp_Dir out(std::cos(turned), std::sin(turned), 0), normal(std::sin(turned), -std::cos(turned), 0);
  const gp_Circ meridian(gp_Ax2({0, 0, 0}, normal, out), radius);
  const TopoDS_Edge wire = BRepBuilderAPI_MakeEdge(meridian, 0, 0.5 * M_PI);
  const RunReport report = test::report_of(compound({ball(), wire}), 2);
  EXPECT_STREQ(verdict(report), "sound");
  EXPECT_NEAR(static_cast<double>(report.quality.wire_lines), quarter_nodes(2), 1);
  ASSERT_EQ(report.components.size(), 1u);
  EXPECT_EQ(report.components[0], (std::vector<std::string>{"Solid1", "Wire1"}));
}

}  // namespace
}  // namespace paver
