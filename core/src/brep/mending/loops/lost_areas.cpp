// Faces for which the kernel finds no area, though they have one. A face without area has a border that runs back along
// itself: beside every place of it there is one where it goes the other way, as on both sides of a sliver, or it is
// shorter than that sliver is wide. What has a border of another kind is faulty, as drawn or as read.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Wire.hxx>
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
/// Ways lead round by whole periods up to this share of one.
constexpr double round_share = 1e-2;
constexpr int foot_steps = 6;
constexpr double meridian_share = 1e-6;  // of the period: places of one meridian
constexpr double pole_share = 1e-6;      // of the diagonal: a row so small is a pole

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

/// An edge as its loop walks it.
struct Step {
  TopoDS_Edge edge;
  Vec2 way;  ///< of its image, from start to end
  bool is_closed = false;
};

/// Empty where an edge has no image, and for poles.
std::vector<Step> steps_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<Step> steps;
  bool is_whole = true;
  is_whole &= visit_border(wire, [&](const TopoDS_Edge& edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
    const EdgeImage image = image_of(edge, face);
    is_whole = is_whole && !image.curve.IsNull() && image.is_finite() && !BRep_Tool::Degenerated(edge);
    if (!is_whole) return;
    const gp_Pnt2d from = image.uv(0), to = image.uv(1);
    const double sign = edge.Orientation() == TopAbs_REVERSED ? -1 : 1;
    steps.push_back({edge, {sign * (to.X() - from.X()), sign * (to.Y() - from.Y())}, first.IsSame(last)});
  });
  return is_whole ? steps : std::vector<Step>{};
}

/// Whether a way leads once round the surface.
bool goes_round(Vec2 way, const Handle(Geom_Surface) & surface) {
  const Vec2 period{surface->IsUPeriodic() ? surface->UPeriod() : 0, surface->IsVPeriodic() ? surface->VPeriod() : 0};
  auto is_once = [](double sum, double other, double once) {
    return once > 0 && std::abs(std::abs(sum) - once) + std::abs(other) <= round_share * once;
  };
  return is_once(way.x, way.y, period.x) || is_once(way.y, way.x, period.y);
}

/// A FORWARD face without the edge by which a reader has closed the image of its one loop, which goes round: that edge
/// runs back along all of the loop, and nothing is left between them. It is put in as the first; where it is the last,
/// the reader has turned the loop with it.
std::optional<TopoDS_Face> without_closing_edge(const TopoDS_Face& face) {
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face, location));
  if (wires.size() != 1 || surface.IsNull()) return std::nullopt;
  std::vector<Step> steps = steps_of(wires[0], face);
  if (steps.size() < 2) return std::nullopt;
  auto closes = [&](const Step& step) { return step.is_closed && goes_round(step.way, surface); };
  const bool is_turned = !closes(steps.front());
  if (is_turned) std::reverse(steps.begin(), steps.end());
  if (!closes(steps.front())) return std::nullopt;
  Vec2 rest;
  for (std::size_t i = 1; i < steps.size(); ++i) rest = rest + steps[i].way;
  if (!goes_round(rest, surface) || dot(rest, steps.front().way) > 0) return std::nullopt;
  TopoDS_Wire wire;
  BRep_Builder builder;
  builder.MakeWire(wire);
  for (std::size_t i = 1; i < steps.size(); ++i)
    builder.Add(wire, is_turned ? steps[i].edge.Reversed() : TopoDS_Shape(steps[i].edge));
  TopoDS_Face made = TopoDS::Face(face.EmptyCopied());
  builder.Add(made, wire);
  return made;
}

/// Where the one loop of a face runs along a line of one u of a surface that is closed in u: the least and the largest
/// v.
std::optional<std::array<double, 2>> ends_on_meridian(const TopoDS_Face& face, const Handle(Geom_Surface) & surface) {
  const std::vector<TopoDS_Wire> wires = wires_of(face);
  if (wires.size() != 1 || surface.IsNull() || !surface->IsUClosed()) return std::nullopt;
  const std::vector<Step> steps = steps_of(wires[0], face);
  if (steps.empty()) return std::nullopt;
  double first = 0, last = 0, v0 = 0, v1 = 0;
  surface->Bounds(first, last, v0, v1);
  const gp_Pnt2d start = image_of(steps[0].edge, face).uv(0);
  v0 = v1 = start.Y();
  for (const Step& step : steps)
    for (const double share : {0.0, 0.5, 1.0}) {
      const gp_Pnt2d uv = image_of(step.edge, face).uv(share);
      if (std::abs(uv.X() - start.X()) > meridian_share * (last - first)) return std::nullopt;
      v0 = std::min(v0, uv.Y()), v1 = std::max(v1, uv.Y());
    }
  return std::array{v0, v1};
}

/// A FORWARD face whose one loop runs along a meridian from pole to pole and back, as the edge between its periods
/// does: all of the surface between these poles. Readers put both images in one place.
std::optional<TopoDS_Face> all_round(const TopoDS_Face& face, double diagonal) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face, location));
  const auto ends = ends_on_meridian(face, surface);
  if (!ends) return std::nullopt;
  double first = 0, last = 0, from = 0, to = 0;
  surface->Bounds(first, last, from, to);
  for (const double v : *ends)
    for (const double u : {0.75 * first + 0.25 * last, 0.5 * (first + last), 0.25 * first + 0.75 * last})
      if (surface->Value(first, v).Distance(surface->Value(u, v)) > pole_share * diagonal) return std::nullopt;
  BRepBuilderAPI_MakeFace maker(surface, first, last, (*ends)[0], (*ends)[1], Precision::Confusion());
  return maker.IsDone() ? std::optional(TopoDS::Face(maker.Face().Moved(location))) : std::nullopt;
}

/// A sliver along a meridian has neighbours.
bool has_neighbour(const WorkFace& face, const Workpiece& work) {
  const std::vector<TopoDS_Edge> edges = edges_of(face.face);
  return std::ranges::any_of(work.faces, [&](const WorkFace& other) {
    return &other != &face &&
           std::ranges::any_of(edges, [&](const auto& edge) { return use_count(edge, other.face) > 0; });
  });
}

/// Whether the face was all round; it is now.
bool take_all_round(WorkFace& face, Workpiece& work) {
  const std::optional<TopoDS_Face> whole = all_round(forward(face.face), work.diagonal);
  if (!whole || has_neighbour(face, work)) return false;
  copy_shape(work);
  face.face = TopoDS::Face(whole->Oriented(face.face.Orientation()));
  face.area = face_area(face.face);
  face.has_area = work.is_area(face.area);
  work.note_repair(RepairKind::periodic_edge, 1, 0, face_name(face.origin));
  work.is_rebuilt = true;
  return true;
}

/// Whether a face is what readers leave of one that went round: its border is a line of no other face, and no short
/// one.
bool is_cut_down(const WorkFace& face, const Workpiece& work) {
  TopLoc_Location location;
  const TopoDS_Face plain = forward(face.face);
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(plain, location));
  if (!ends_on_meridian(plain, surface) || has_neighbour(face, work)) return false;
  return edge_length(edges_of(plain).front()) > end_widths * width_share * work.diagonal;
}

void fault(Workpiece& work, WorkFace& face, const TopoDS_Edge& edge, const std::string& what) {
  face.fault = what + at_edge(work, edge) + "; repair it in the CAD program";
  face.has_area = true;
}

}  // namespace

void open_lost_caps(Workpiece& work) {
  for (WorkFace& face : work.faces) {
    if (face.has_area || face.is_dropped || !face.fault.empty()) continue;
    if (take_all_round(face, work) || !without_closing_edge(forward(face.face))) continue;
    copy_shape(work);
    const std::optional<TopoDS_Face> cap = without_closing_edge(forward(face.face));
    face.face = TopoDS::Face(cap->Oriented(face.face.Orientation()));
    work.is_rebuilt = true;
  }
}

void fault_lost_areas(Workpiece& work) {
  for (WorkFace& face : work.faces) {
    if (face.has_area || face.is_dropped || !face.fault.empty()) continue;
    try {
      const TopoDS_Face plain = forward(face.face);
      const TopoDS_Edge edge = Border(plain, work.diagonal).enclosing_edge();
      if (edge.IsNull()) {
        if (is_cut_down(face, work))
          fault(work, face, edges_of(plain).front(), "its boundary is a line from which its surface goes round");
        continue;
      }
      const bool is_open = find_loop_faults(plain, work.diagonal).open > 0;
      fault(work, face, edge,
            is_open ? "its boundary is open" : "its boundary encloses something where its surface has no area");
    } catch (const Standard_Failure&) {
      // What cannot be evaluated at all has no area to lose.
    }
  }
}

}  // namespace paver
