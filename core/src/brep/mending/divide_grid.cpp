// Divides a B-spline or swept face bounded by the four sides of a rectangle in (u, v) into the cells of a grid:
//   line 2 +---+-----+   Rows and columns pressed flat onto a line are left out: the lines on both sides of one are one
//    row 1 |   |     |   line, used by the cells above and below at different parameters.
//   line 1 +---+-----+   Edges of the face are divided at the lines, once, for all faces that share them.
//    row 0 |   |     |
//   line 0 +---+-----+
#include <BRepAdaptor_Curve.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_SweptSurface.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "brep/mending/divide_face_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Sides of the rectangle and ends of its lines are met up to this share of its range.
constexpr double side_share = 1e-6;
/// Points of lines that are one lie within this share of the diagonal.
constexpr double line_share = 1e-6;
constexpr int line_samples = 16;
constexpr int bisections = 60;

/// Part of a side: an edge, and which way it runs.
struct SideEdge {
  TopoDS_Edge edge;  ///< FORWARD
  double low = 0, high = 0;
  bool is_rising = true;       ///< runs towards growing parameters
  Handle(Geom2d_Curve) image;  ///< of a new edge none
};

/// One direction of the grid: 0 is u, 1 is v.
struct Axis {
  double low = 0, high = 0;
  std::vector<std::array<double, 2>> spans;
};

gp_Pnt2d uv_of(int axis, double along, double across) {
  return axis == 0 ? gp_Pnt2d(along, across) : gp_Pnt2d(across, along);
}

class GridDivider {
 public:
  GridDivider(const TopoDS_Face& face, const std::array<std::vector<GridSpan>, 2>& spans, double diagonal)
      : face_(face), diagonal_(diagonal) {
    for (int axis : {0, 1}) {
      axes_[axis].low = spans[axis].front().low;
      axes_[axis].high = spans[axis].back().high;
      for (const GridSpan& span : spans[axis])
        if (!span.is_flat) axes_[axis].spans.push_back({span.low, span.high});
    }
  }

  Division divide() {
    if (!find_surface() || axes_[0].spans.empty() || axes_[1].spans.empty() || !find_sides()) return {};
    for (int axis : {0, 1})
      for (int end : {0, 1})
        if (!lies_on_side(axis, end)) return {};
    divide_sides();
    make_inner_lines();
    return {make_cells(), std::move(replaced_)};
  }

 private:
  using Line = std::vector<SideEdge>;

  double slack(int axis) const { return side_share * (axes_[axis].high - axes_[axis].low); }
  gp_Pnt point(int axis, double along, double across) const {
    gp_Pnt2d uv = uv_of(axis, along, across);
    return surface_->Value(uv.X(), uv.Y()).Transformed(location_.Transformation());
  }

  bool find_surface() {
    surface_ = untrimmed(BRep_Tool::Surface(face_, location_));
    return surface_->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) || surface_->IsKind(STANDARD_TYPE(Geom_SweptSurface));
  }

  /// Every edge must lie on one of the sides, whole; twice on one, where the face is pressed flat, only where it needs
  /// no division.
  bool find_sides() {
    for (const TopoDS_Edge& edge : edges_of(face_))
      if (!add_to_side(edge, image_of(edge, face_))) return false;
    for (int axis : {0, 1}) {
      for (Line& side : sides_[axis]) {
        std::sort(side.begin(), side.end(), [](const SideEdge& a, const SideEdge& b) { return a.low < b.low; });
        if (!covers(side, axis) || runs_back(side, axis)) return false;
      }
    }
    return true;
  }

  bool runs_back(const Line& side, int axis) const {
    return std::ranges::any_of(side, [&](const SideEdge& part) {
      return !cuts_of(part, axis).empty() &&
             std::ranges::count_if(side, [&](const SideEdge& other) { return other.edge.IsSame(part.edge); }) > 1;
    });
  }

  bool add_to_side(const TopoDS_Edge& edge, const EdgeImage& image) {
    if (image.curve.IsNull()) return false;
    const double t0 = image.first, t1 = image.last;
    for (int axis : {0, 1}) {
      for (int end : {0, 1}) {
        const Axis& across = axes_[1 - axis];
        double value = end == 0 ? across.low : across.high;
        bool is_on = true;
        for (int i = 0; i <= line_samples; ++i)
          is_on &= std::abs(coordinate(image.curve->Value(t0 + (t1 - t0) * i / line_samples), 1 - axis) - value) <=
                   slack(1 - axis);
        if (!is_on) continue;
        double a = coordinate(image.curve->Value(t0), axis), b = coordinate(image.curve->Value(t1), axis);
        sides_[axis][end].push_back({forward(edge), std::min(a, b), std::max(a, b), a < b, image.curve});
        return true;
      }
    }
    return false;
  }

  /// Neighbours divided before have left out parts in flat strips.
  bool covers(const Line& side, int axis) const {
    for (const auto& span : spans(axis)) {
      double reached = span[0];
      for (const SideEdge& part : side)
        if (part.low <= reached + slack(axis)) reached = std::max(reached, part.high);
      if (reached < span[1] - slack(axis)) return false;
    }
    return true;
  }

  static double coordinate(const gp_Pnt2d& uv, int axis) { return axis == 0 ? uv.X() : uv.Y(); }

  /// Where flat strips are left out, the cells end at another parameter than the side, at the same points.
  bool lies_on_side(int axis, int end) const {
    const Axis& across = axes_[1 - axis];
    double side = end == 0 ? across.low : across.high;
    double cell = end == 0 ? across.spans.front()[0] : across.spans.back()[1];
    for (int i = 0; i <= line_samples; ++i) {
      double along = axes_[axis].low + (axes_[axis].high - axes_[axis].low) * i / line_samples;
      if (point(axis, along, side).Distance(point(axis, along, cell)) > line_share * diagonal_) return false;
    }
    return true;
  }

  void divide_sides() {
    for (int axis : {0, 1}) {
      lines_[axis].assign(spans(1 - axis).size() + 1, std::vector<Line>(spans(axis).size()));
      for (int end : {0, 1}) {
        auto& line = end == 0 ? lines_[axis].front() : lines_[axis].back();
        for (const SideEdge& part : sides_[axis][end]) divide_edge(part, axis, line);
      }
    }
  }

  const std::vector<std::array<double, 2>>& spans(int axis) const { return axes_[axis].spans; }

  /// Puts the parts of an edge into the spans they belong to.
  void divide_edge(const SideEdge& whole, int axis, std::vector<Line>& line) {
    for (const SideEdge& part : parts_of(whole, axis)) {
      double middle = 0.5 * (part.low + part.high);
      for (std::size_t s = 0; s < line.size(); ++s)
        if (middle > spans(axis)[s][0] && middle < spans(axis)[s][1]) line[s].push_back(part);
    }
  }

  /// A periodic edge, met on two sides, is divided when it is met first.
  std::vector<SideEdge> parts_of(const SideEdge& whole, int axis) {
    auto known = std::find_if(divided_.begin(), divided_.end(),
                              [&](const auto& entry) { return entry.first.IsSame(whole.edge); });
    if (known != divided_.end()) {
      std::vector<SideEdge> parts = known->second;
      for (SideEdge& part : parts) part.image = whole.image;
      return parts;
    }
    std::vector<SideEdge> parts = cut(whole, axis);
    if (parts.size() == 1) return parts;
    divided_.push_back({whole.edge, parts});
    replace(whole, parts, axis);
    return parts;
  }

  std::vector<double> cuts_of(const SideEdge& whole, int axis) const {
    std::vector<double> values;
    for (const auto& span : spans(axis))
      for (double value : span)
        if (value > whole.low + slack(axis) && value < whole.high - slack(axis)) values.push_back(value);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

  std::vector<SideEdge> cut(const SideEdge& whole, int axis) {
    std::vector<double> values = cuts_of(whole, axis);
    if (values.empty()) return {whole};
    values.insert(values.begin(), whole.low);
    values.push_back(whole.high);
    TopoDS_Vertex first, last;
    TopExp::Vertices(whole.edge, first, last);
    if (!whole.is_rising) std::swap(first, last);
    std::vector<SideEdge> parts;
    TopoDS_Vertex start = first;
    for (std::size_t i = 0; i + 1 < values.size(); ++i) {
      bool is_last = i + 2 == values.size();
      TopoDS_Vertex end = is_last ? last : vertex_at(whole, axis, values[i + 1], first, last);
      parts.push_back(part_of(whole, axis, values[i], values[i + 1], start, end));
      start = end;
    }
    return parts;
  }

  TopoDS_Vertex vertex_at(const SideEdge& whole, int axis, double value, const TopoDS_Vertex& first,
                          const TopoDS_Vertex& last) const {
    if (BRep_Tool::Degenerated(whole.edge)) return first;
    gp_Pnt at = BRepAdaptor_Curve(whole.edge).Value(parameter(whole, axis, value));
    for (const TopoDS_Vertex& end : {first, last})
      if (BRep_Tool::Pnt(end).Distance(at) <= line_share * diagonal_) return end;
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, at, BRep_Tool::Tolerance(whole.edge));
    return vertex;
  }

  /// Edge parameter where the image passes `value`.
  static double parameter(const SideEdge& whole, int axis, double value) {
    auto [low, high] = range_of(whole.edge);
    for (int i = 0; i < bisections; ++i) {
      double middle = 0.5 * (low + high);
      bool is_below = coordinate(whole.image->Value(middle), axis) < value;
      (is_below == whole.is_rising ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  SideEdge part_of(const SideEdge& whole, int axis, double low, double high, const TopoDS_Vertex& start,
                   const TopoDS_Vertex& end) const {
    SideEdge part = whole;
    part.low = low;
    part.high = high;
    const auto [t0, t1] = range_of(whole.edge);
    double from = low == whole.low ? (whole.is_rising ? t0 : t1) : parameter(whole, axis, low);
    double to = high == whole.high ? (whole.is_rising ? t1 : t0) : parameter(whole, axis, high);
    part.edge = TopoDS::Edge(whole.edge.EmptyCopied());
    BRep_Builder builder;
    builder.Range(part.edge, std::min(from, to), std::max(from, to));
    builder.Add(part.edge, (whole.is_rising ? start : end).Oriented(TopAbs_FORWARD));
    builder.Add(part.edge, (whole.is_rising ? end : start).Oriented(TopAbs_REVERSED));
    return part;
  }

  /// Other faces get the parts that have length; those in flat strips have none.
  void replace(const SideEdge& whole, const std::vector<SideEdge>& parts, int axis) {
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const SideEdge& part : parts) {
      double middle = 0.5 * (part.low + part.high);
      bool is_kept = std::any_of(spans(axis).begin(), spans(axis).end(),
                                 [&](const auto& span) { return middle > span[0] && middle < span[1]; });
      if (is_kept) builder.Add(wire, part.edge);
    }
    replaced_.push_back({whole.edge, wire});
  }

  TopoDS_Vertex end_of(const Line& line, bool is_low) const {
    const SideEdge& part = is_low ? line.front() : line.back();
    TopoDS_Vertex first, last;
    TopExp::Vertices(part.edge, first, last);
    return is_low == part.is_rising ? first : last;
  }

  double line_value(int axis, std::size_t line) const {
    return line == 0 ? spans(axis).front()[0] : spans(axis)[line - 1][1];
  }

  /// Where line i of constant u meets line j of constant v: on the sides a vertex of theirs.
  TopoDS_Vertex node(std::size_t i, std::size_t j) {
    std::size_t columns = spans(0).size(), rows = spans(1).size();
    if (j == 0 || j == rows) return node_on(lines_[0][j], i);
    if (i == 0 || i == columns) return node_on(lines_[1][i], j);
    auto [found, is_new] = nodes_.try_emplace({i, j});
    if (is_new) BRep_Builder().MakeVertex(found->second, point(0, line_value(0, i), line_value(1, j)), edge_tolerance);
    return found->second;
  }

  TopoDS_Vertex node_on(const std::vector<Line>& line, std::size_t i) const {
    return i < line.size() ? end_of(line[i], true) : end_of(line[i - 1], false);
  }

  void make_inner_lines() {
    for (int axis : {0, 1})
      for (std::size_t k = 1; k < spans(1 - axis).size(); ++k)
        for (std::size_t s = 0; s < spans(axis).size(); ++s) lines_[axis][k][s] = {inner_edge(axis, k, s)};
  }

  SideEdge inner_edge(int axis, std::size_t k, std::size_t s) {
    SideEdge part;
    part.low = spans(axis)[s][0];
    part.high = spans(axis)[s][1];
    double across = line_value(1 - axis, k);
    BRep_Builder builder;
    double extent = 0;
    gp_Pnt start = point(axis, part.low, across);
    for (int i = 1; i <= line_samples; ++i)
      extent =
          std::max(extent, start.Distance(point(axis, part.low + (part.high - part.low) * i / line_samples, across)));
    if (extent > line_share * diagonal_) {
      Handle(Geom_Curve) curve = axis == 0 ? surface_->VIso(across) : surface_->UIso(across);
      builder.MakeEdge(part.edge, curve, location_, edge_tolerance);
    } else {
      builder.MakeEdge(part.edge);
      builder.Degenerated(part.edge, Standard_True);
    }
    builder.Range(part.edge, part.low, part.high);
    builder.Add(part.edge, (axis == 0 ? node(s, k) : node(k, s)).Oriented(TopAbs_FORWARD));
    builder.Add(part.edge, (axis == 0 ? node(s + 1, k) : node(k, s + 1)).Oriented(TopAbs_REVERSED));
    return part;
  }

  TopoDS_Shape make_cells() {
    BRep_Builder builder;
    TopoDS_Compound cells;
    builder.MakeCompound(cells);
    for (std::size_t j = 0; j < spans(1).size(); ++j)
      for (std::size_t i = 0; i < spans(0).size(); ++i) builder.Add(cells, make_cell(i, j));
    return cells;
  }

  /// Its own, as edges keep one image or two per surface.
  Handle(Geom_Surface) surface_of_cell(std::size_t i, std::size_t j) const {
    auto [u0, u1] = spans(0)[i];
    auto [v0, v1] = spans(1)[j];
    const auto own = Handle(Geom_Surface)::DownCast(surface_->Copy());
    if (auto spline = Handle(Geom_BSplineSurface)::DownCast(own)) {
      spline->Segment(u0, u1, v0, v1);
      return spline;
    }
    // A direction that is whole stays periodic.
    if (spans(1).size() == 1) return new Geom_RectangularTrimmedSurface(own, u0, u1, Standard_True);
    if (spans(0).size() == 1) return new Geom_RectangularTrimmedSurface(own, v0, v1, Standard_False);
    return new Geom_RectangularTrimmedSurface(own, u0, u1, v0, v1);
  }

  TopoDS_Face make_cell(std::size_t i, std::size_t j) {
    auto [u0, u1] = spans(0)[i];
    auto [v0, v1] = spans(1)[j];
    const Handle(Geom_Surface) surface = surface_of_cell(i, j);
    BRep_Builder builder;
    TopoDS_Face cell;
    builder.MakeFace(cell, surface, location_, BRep_Tool::Tolerance(face_));
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    add_pair(wire, surface, 0, lines_[0][j][i], v0, lines_[0][j + 1][i], v1);
    add_pair(wire, surface, 1, lines_[1][i + 1][j], u1, lines_[1][i][j], u0);
    wire.Closed(Standard_True);
    builder.Add(cell, wire);
    return cell;
  }

  /// `rising` is run towards growing parameters, `falling`, its opposite, the other way.
  void add_pair(TopoDS_Wire& wire, const Handle(Geom_Surface) & surface, int axis, const Line& rising, double rising_at,
                const Line& falling, double falling_at) const {
    BRep_Builder builder;
    for (const SideEdge& part : rising) {
      auto partner = std::find_if(falling.begin(), falling.end(),
                                  [&](const SideEdge& other) { return other.edge.IsSame(part.edge); });
      Handle(Geom2d_Curve) image = image_at(part, axis, rising_at);
      if (partner == falling.end()) {
        builder.UpdateEdge(part.edge, image, surface, location_, edge_tolerance);
      } else {
        Handle(Geom2d_Curve) other = image_at(*partner, axis, falling_at);
        builder.UpdateEdge(part.edge, part.is_rising ? image : other, part.is_rising ? other : image, surface,
                           location_, edge_tolerance);
      }
      builder.Add(wire, part.edge.Oriented(part.is_rising ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
    for (const SideEdge& part : falling) {
      bool is_periodic = std::any_of(rising.begin(), rising.end(),
                                     [&](const SideEdge& other) { return other.edge.IsSame(part.edge); });
      if (!is_periodic)
        builder.UpdateEdge(part.edge, image_at(part, axis, falling_at), surface, location_, edge_tolerance);
      builder.Add(wire, part.edge.Oriented(part.is_rising ? TopAbs_REVERSED : TopAbs_FORWARD));
    }
  }

  /// The image, moved to where the cell's border is.
  Handle(Geom2d_Curve) image_at(const SideEdge& part, int axis, double across) const {
    if (part.image.IsNull()) {
      gp_Dir2d along = axis == 0 ? gp::DX2d() : gp::DY2d();
      return new Geom2d_Line(uv_of(axis, 0, across), along);
    }
    auto moved = Handle(Geom2d_Curve)::DownCast(part.image->Copy());
    const auto [t0, t1] = range_of(part.edge);
    double now = coordinate(part.image->Value(0.5 * (t0 + t1)), 1 - axis);
    gp_Pnt2d shift = uv_of(axis, 0, across - now);
    moved->Translate(gp_Vec2d(shift.X(), shift.Y()));
    return moved;
  }

  static constexpr double edge_tolerance = 1e-7;  // mm, the kernel's own for exact curves

  const TopoDS_Face& face_;
  double diagonal_;
  TopLoc_Location location_;
  Handle(Geom_Surface) surface_;
  std::array<Axis, 2> axes_;
  std::array<std::array<Line, 2>, 2> sides_;             ///< per axis they run along: at the low and at the high end
  std::array<std::vector<std::vector<Line>>, 2> lines_;  ///< per axis, line and span: its edges
  std::vector<std::pair<TopoDS_Edge, std::vector<SideEdge>>> divided_;
  std::vector<std::pair<TopoDS_Edge, TopoDS_Wire>> replaced_;
  std::map<std::pair<std::size_t, std::size_t>, TopoDS_Vertex> nodes_;
};

}  // namespace

Division divide_grid(const TopoDS_Face& face, const std::array<std::vector<GridSpan>, 2>& spans, double diagonal) {
  return GridDivider(face, spans, diagonal).divide();
}

}  // namespace paver
