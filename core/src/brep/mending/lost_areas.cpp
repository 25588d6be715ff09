// Faces for which the kernel finds no area, though they have one. A face without area has a border that runs back along
// itself: beside every place of it there is one where it goes the other way, as on both sides of a sliver, or it is
// shorter than that sliver is wide. What has a border of another kind is faulty, as drawn or as read.
#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// A face below no_area_share is no wider than this share of the diagonal.
constexpr double width_share = 2e-5;
/// Edges claim to lie no farther off than their tolerance, of which no more than this share of the diagonal is
/// believed.
constexpr double most_share = 3e-3;
/// The ends of a sliver run across it: so many widths of border may be without one that goes the other way.
constexpr double end_widths = 4;
constexpr int pieces = 64;
constexpr int foot_steps = 6;

struct BorderEdge {
  TopoDS_Edge edge;
  SampledCurve line;  ///< as the border runs
  double tolerance = 0;
};

class Border {
 public:
  Border(const TopoDS_Face& face, double diagonal) : diagonal_(diagonal) {
    for (const TopoDS_Wire& wire : wires_of(face))
      visit_border(wire, [&](const TopoDS_Edge& edge, const auto&, const auto&) { add(edge); });
  }

  /// An edge where the border does not run back along itself, over more than the ends of a sliver; null where it does.
  TopoDS_Edge enclosing_edge() const {
    const double width = width_share * diagonal_;
    double length = 0, most = 0;
    const BorderEdge* longest = nullptr;
    for (const BorderEdge& one : edges_) {
      const double own = lonely_length(one);
      length += own;
      if (own > most) most = own, longest = &one;
    }
    return longest && length > end_widths * width ? longest->edge : TopoDS_Edge();
  }

 private:
  void add(const TopoDS_Edge& edge) {
    const auto curve = BRep_Tool::Degenerated(edge) ? nullptr : make_curve(edge);
    const CurveRange range = range_of(edge);
    if (!curve || !range.is_finite()) return;
    auto [t0, t1] = range;
    if (edge.Orientation() == TopAbs_REVERSED) std::swap(t0, t1);
    edges_.push_back(
        {edge, sampled(curve, t0, t1, pieces), std::min(BRep_Tool::Tolerance(edge), most_share * diagonal_)});
  }

  /// Length of an edge along which nothing goes the other way.
  double lonely_length(const BorderEdge& one) const {
    double length = 0;
    const auto& [curve, t, points] = one.line;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec3 along = points[k] - points[k - 1], x = curve->point(0.5 * (t[k - 1] + t[k]));
      auto is_beside = [&](const BorderEdge& other) { return runs_back(other, x, along, one.tolerance); };
      if (std::none_of(edges_.begin(), edges_.end(), is_beside)) length += norm(along);
    }
    return length;
  }

  /// Whether an edge comes by `x` the other way.
  bool runs_back(const BorderEdge& edge, Vec3 x, Vec3 along, double tolerance) const {
    const double allowed = std::max(width_share * diagonal_, tolerance + edge.tolerance);
    const auto& [curve, t, points] = edge.line;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vec3 a = points[k - 1], side = points[k] - a;
      if (!(dot(side, along) < 0)) continue;
      const double share = std::clamp(dot(x - a, side) / dot(side, side), 0.0, 1.0);
      // The curve leaves its chord by less than the chord is long.
      const double off = norm(x - (a + share * side));
      if (!(off <= allowed + norm(side))) continue;
      const double foot = t[k - 1] + share * (t[k] - t[k - 1]);
      if (off <= allowed || distance_near(edge.line, k, foot, foot_steps, x) <= allowed) return true;
    }
    return false;
  }

  double diagonal_;
  std::vector<BorderEdge> edges_;
};

bool is_round(const TopoDS_Edge& edge) {
  return !BRep_Tool::Degenerated(edge) && TopExp::FirstVertex(edge).IsSame(TopExp::LastVertex(edge));
}

/// Whether an edge runs along another one.
bool runs_along(const TopoDS_Edge& edge, const TopoDS_Edge& other, double allowed) {
  const auto curve = make_curve(edge), second = make_curve(other);
  if (!curve || !second || !range_of(edge).is_finite() || !range_of(other).is_finite()) return false;
  const auto [t0, t1] = range_of(edge);
  const auto [s0, s1] = range_of(other);
  const SampledCurve line = sampled(second, s0, s1, pieces);
  for (double share : {0.2, 0.5, 0.8}) {
    if (!(distance_to(line, foot_steps, curve->point(t0 + share * (t1 - t0))) <= allowed)) return false;
  }
  return true;
}

void fault(Workpiece& work, WorkFace& face, const TopoDS_Edge& edge, const std::string& what) {
  face.fault = what + at_edge(work, edge) + "; repair it in the CAD program";
  face.has_area = true;
}

}  // namespace

void fault_lost_caps(Workpiece& work) {
  std::optional<std::vector<TopoDS_Edge>> free;
  for (WorkFace& face : work.faces) {
    if (face.has_area || face.is_dropped || !face.fault.empty()) continue;
    const std::vector<TopoDS_Edge> border = edges_of(face.face);
    if (border.empty() || !std::ranges::all_of(border, is_round)) continue;
    if (BRepAdaptor_Surface(face.face, Standard_False).GetType() == GeomAbs_Plane) continue;
    auto is_open = [&](const TopoDS_Edge& other) { return runs_along(border[0], other, width_share * work.diagonal); };
    if (!free) free = count_uses(work.faces).free_edges();
    if (std::ranges::any_of(*free, is_open))
      fault(work, face, border[0], "its border is there twice, and what it enclosed is lost");
  }
}

void fault_lost_areas(Workpiece& work) {
  for (WorkFace& face : work.faces) {
    if (face.has_area || face.is_dropped || !face.fault.empty()) continue;
    try {
      const TopoDS_Face plain = forward(face.face);
      const TopoDS_Edge edge = Border(plain, work.diagonal).enclosing_edge();
      if (edge.IsNull()) continue;
      const bool is_open = find_loop_faults(plain, work.diagonal).open > 0;
      fault(work, face, edge,
            is_open ? "its boundary is open" : "its boundary encloses something where its surface has no area");
    } catch (const Standard_Failure&) {
      // What cannot be evaluated at all has no area to lose.
    }
  }
}

}  // namespace paver
