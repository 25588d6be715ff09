// Splines that are lines or arcs of circles, by points of them.
#include <ElCLib.hxx>
#include <GC_MakeCircle.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <numbers>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "brep/recognising/recognise_impl.h"

namespace paver {
namespace {

/// Odd, so that the middle is one.
constexpr int samples = 17;

struct Found {
  Handle(Geom_Curve) curve;
  double last = 0;
};

bool is_spline(const Handle(Geom_Curve) & curve) {
  return curve->IsKind(STANDARD_TYPE(Geom_BSplineCurve)) || curve->IsKind(STANDARD_TYPE(Geom_BezierCurve));
}

std::optional<Found> line_through(const std::vector<gp_Pnt>& points) {
  const double length = points.front().Distance(points.back());
  if (length <= Precision::Confusion()) return std::nullopt;
  return Found{new Geom_Line(points.front(), gp_Dir(gp_Vec(points.front(), points.back()))), length};
}

/// Through three of the points, from the first one on, and all round where that is the last one, too.
std::optional<Found> circle_through(const std::vector<gp_Pnt>& points) {
  const bool is_closed = points.front().Distance(points.back()) <= Precision::Confusion();
  const std::size_t step = (points.size() - 1) / (is_closed ? 3 : 2);
  const GC_MakeCircle maker(points.front(), points[step], points[2 * step]);
  if (!maker.IsDone()) return std::nullopt;
  const gp_Circ through = maker.Value()->Circ();
  const gp_Dir to_start(gp_Vec(through.Location(), points.front()));
  const gp_Circ circle(gp_Ax2(through.Location(), through.Axis().Direction(), to_start), through.Radius());
  const double last = is_closed ? 2 * std::numbers::pi : ElCLib::Parameter(circle, points.back());
  return Found{new Geom_Circle(circle), last};
}

double parameter_on(const Handle(Geom_Curve) & curve, const gp_Pnt& point) {
  if (const auto line = Handle(Geom_Line)::DownCast(curve)) return ElCLib::Parameter(line->Lin(), point);
  return ElCLib::Parameter(Handle(Geom_Circle)::DownCast(curve)->Circ(), point);
}

/// Whether it passes by the points, one behind the other.
bool passes(const Found& found, const std::vector<gp_Pnt>& points, double tolerance) {
  double before = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double at = parameter_on(found.curve, points[i]);
    if (at <= before || at >= found.last || found.curve->Value(at).Distance(points[i]) > tolerance) return false;
    before = at;
  }
  return points.front().Distance(found.curve->Value(0)) <= tolerance &&
         points.back().Distance(found.curve->Value(found.last)) <= tolerance;
}

}  // namespace

std::optional<PlainCurve> recognise_curve(const TopoDS_Edge& edge, double tolerance) {
  const bool has_inner_vertices = edge.NbChildren() > 2;  // these are there by parameters
  if (BRep_Tool::Degenerated(edge) || has_inner_vertices) return std::nullopt;
  TopLoc_Location location;
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
  if (curve.IsNull() || !is_spline(untrimmed(curve))) return std::nullopt;
  std::vector<gp_Pnt> points;
  for (int i = 0; i < samples; ++i) points.push_back(curve->Value(first + (last - first) * i / (samples - 1)));
  for (const auto through : {line_through, circle_through}) {
    const std::optional<Found> found = through(points);
    if (found && passes(*found, points, tolerance)) return PlainCurve{found->curve, location, found->last};
  }
  return std::nullopt;
}

}  // namespace paver
