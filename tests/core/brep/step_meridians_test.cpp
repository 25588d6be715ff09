// Parts of balls, placed askew, written to STEP with few decimals and read again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_Ellipse.hxx>
#include <fstream>
#include <numbers>
#include <regex>
#include <sstream>

#include "brep/occt_impl.h"
#include "core/brep/shape_files.h"
#include "core/brep/step_files.h"

namespace paver {
namespace {

using test::area_of;

constexpr double right = std::numbers::pi / 2;

TopoDS_Shape askew(const TopoDS_Shape& shape) {
  gp_Trsf turn, shift;
  turn.SetRotation(gp_Ax1({0, 0, 0}, {1, 2, 3}), 0.65);
  shift.SetTranslation({12.345, -3.21, 7.7});
  return BRepBuilderAPI_Transform(shape, shift * turn).Shape();
}

/// Of points and directions in a STEP file.
void round_numbers(const std::string& path, int decimals) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  const std::regex number(R"(-?\d+\.\d*(E[+-]?\d+)?)");
  std::string rounded;
  for (std::string line; std::getline(text, line); rounded += line + "\n") {
    if (line.find("CARTESIAN_POINT") == std::string::npos && line.find("DIRECTION") == std::string::npos) continue;
    std::string next;
    for (std::smatch found; std::regex_search(line, found, number); line = found.suffix())
      next += found.prefix().str() + fmt::format("{:.{}f}", std::stod(found.str()), decimals);
    line = next + line;
  }
  std::ofstream(path) << rounded;
}

Model read_rounded(const TopoDS_Shape& shape, int decimals) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("model.step");
  test::write_step(shape, path);
  round_numbers(path, decimals);
  ModelReport report;
  Progress progress;
  const std::shared_ptr<Shape> read = read_shape(path, report, progress);
  test::Alone alone(progress);
  Options options;
  options.size = 1;
  return build_model(*read, options, {}, progress, alone);
}

/// Images, too, lie where their edges do.
void expect_as_drawn(const TopoDS_Shape& shape, int decimals, double near) {
  SCOPED_TRACE(fmt::format("{} decimals", decimals));
  const Model model = read_rounded(shape, decimals);
  double area = 0;
  for (const Face& face : model.faces) {
    area += face.area;
    EXPECT_EQ(face.fault, "");
    for (const Coedge& coedge : coedges_of(face.loops)) {
      const Edge& edge = edge_of(model, coedge);
      for (double share : {0.1, 0.5, 0.9, 0.999}) {
        if (edge.is_degenerate || !edge.curve) continue;
        const double t = edge.parameter(share);
        EXPECT_LT(norm(face.surface->point(coedge.pcurve->uv(t)) - edge.curve->point(t)), near);
      }
    }
  }
  EXPECT_NEAR(area, area_of(shape), 1e-5 * area_of(shape));
}

TEST(StepMeridians, LeadToPolesThatRoundedNumbersMiss) {
  const TopoDS_Shape parts[] = {BRepPrimAPI_MakeSphere(15, 0, right).Shape(),
                                BRepPrimAPI_MakeSphere(15, 0.9, right).Shape(),
                                BRepPrimAPI_MakeSphere(15, -right, right, 2 * right).Shape(),
                                BRepPrimAPI_MakeSphere(15, 0, right, right).Shape()};
  for (const TopoDS_Shape& part : parts)
    for (int decimals : {5, 6, 7}) expect_as_drawn(askew(part), decimals, 1e-3);
}

// The file has a vertex for its border.
TEST(StepMeridians, OfASpindleGoThroughItsPoles) {
  const Handle(Geom_Ellipse) ellipse = new Geom_Ellipse(gp_Ax2({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), 9, 5);
  const TopoDS_Edge half = BRepBuilderAPI_MakeEdge(ellipse, 0, 2 * right).Edge();
  const TopoDS_Shape spindle = BRepPrimAPI_MakeRevol(half, gp_Ax1({0, 0, 0}, {1, 0, 0})).Shape();
  for (int decimals : {5, 6, 7, 9}) expect_as_drawn(askew(spindle), decimals, 1e-3);
}

// Cut off by two planes that pass the axis at a thousandth of the radius.
TEST(StepMeridians, EdgesBesideAPoleStay) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt{0.015, 0.015, 0}, 20, 20, 20).Shape();
  const TopoDS_Shape rest = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(15).Shape(), box).Shape();
  expect_as_drawn(askew(rest), 12, 1e-3);
}

}  // namespace
}  // namespace paver
