// Divides any face along curves in its (u, v), each of which has one place on every iso-line across it.
// 1. Edges are divided where a curve crosses them, once, for all faces that share them.
// 2. Between crossings where a curve is inside the face it becomes an edge.
// 3. The kernel makes faces of all these edges, and each gets the part of the surface that it lies on.
#include <BOPAlgo_BuilderFace.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepLib.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "brep/mending/divide_face_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// Of the diagonal: points that are one lie within it.
constexpr double point_share = 1e-6;
/// Or within the tolerance of a vertex, of which no more than this share is believed.
constexpr double believed_share = 1e-3;
/// Of the curve's range: crossings are one within it.
constexpr double along_share = 1e-6;
/// Of the diagonal: so near to the curve on the surface is that in space.
constexpr double curve_share = 1e-8;
/// Of the curve's range: within that of a vertex it has no other place and no other crossing there.
constexpr double vertex_share = 1e-2;
constexpr int edge_samples = 64;
constexpr int bisections = 60;
constexpr double edge_tolerance = 1e-7;  // mm, the kernel's own for exact curves

/// By the rows' parameter. Slopes are such that it has no extremum between places.
Handle(Geom2d_BSplineCurve) curve_through(const std::map<double, double>& places, bool is_u) {
  const std::vector<std::pair<double, double>> at(places.begin(), places.end());
  const std::size_t count = at.size();
  auto rise = [&](std::size_t i) { return (at[i + 1].second - at[i].second) / (at[i + 1].first - at[i].first); };
  auto slope = [&](std::size_t i) {
    if (i == 0) return rise(0);
    if (i + 1 == count) return rise(i - 1);
    const double one = rise(i - 1), two = rise(i);
    return one * two > 0 ? 2 * one * two / (one + two) : 0;
  };
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(2 * count));
  TColStd_Array1OfReal knots(1, static_cast<int>(count));
  TColStd_Array1OfInteger multiplicities(1, static_cast<int>(count));
  int next = 1;
  auto add = [&](double row, double place) { poles(next++) = is_u ? gp_Pnt2d(place, row) : gp_Pnt2d(row, place); };
  for (std::size_t i = 0; i < count; ++i) {
    const auto [row, place] = at[i];
    knots(static_cast<int>(i) + 1) = row;
    multiplicities(static_cast<int>(i) + 1) = i == 0 || i + 1 == count ? 4 : 2;
    const double before = i == 0 ? 0 : (row - at[i - 1].first) / 3;
    const double after = i + 1 == count ? 0 : (at[i + 1].first - row) / 3;
    add(row - before, place - before * slope(i));
    add(row + after, place + after * slope(i));
  }
  return new Geom2d_BSplineCurve(poles, knots, multiplicities, 3);
}

class AlongDivider {
 public:
  AlongDivider(const TopoDS_Face& face, bool is_u, double diagonal)
      : face_(face),
        surface_(face),
        is_u_(is_u),
        diagonal_(diagonal),
        near_(point_share * diagonal),
        uses_(edges_of(face)) {}

  Division divide(const std::vector<CutCurve>& curves) {
    BRepTopAdaptor_FClass2d inside(face_, Precision::PConfusion());
    TopTools_ListOfShape edges;
    for (const CutCurve& curve : curves) {
      curve_ = curve_through(through_vertices(curve), is_u_);
      curves_.push_back(curve_);
      const std::vector<Crossing> crossings = find_crossings();
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        const double middle = std::midpoint(crossings[i].along, crossings[i + 1].along);
        if (is_on_border(middle) || inside.Perform(curve_->Value(middle)) != TopAbs_IN) continue;
        const TopoDS_Edge edge = inner_edge(crossings[i], crossings[i + 1]);
        edges.Append(edge.Oriented(TopAbs_FORWARD));
        edges.Append(edge.Oriented(TopAbs_REVERSED));
      }
    }
    if (edges.IsEmpty()) return {};
    std::map<const TopoDS_TShape*, std::vector<TopoDS_Edge>> parts;
    Division result;
    for (const auto& [edge, cuts] : cuts_)
      result.divided_edges.push_back({edge, wire_of(parts[edge.TShape().get()] = parts_of(edge, cuts))});
    for (const TopoDS_Edge& use : uses_) {
      const auto divided = parts.find(use.TShape().get());
      if (divided == parts.end())
        edges.Append(use);
      else
        for (const TopoDS_Edge& part : divided->second) edges.Append(part.Oriented(use.Orientation()));
    }
    result.pieces = faces_between(edges);
    return result;
  }

 private:
  struct Crossing {
    double along = 0;
    TopoDS_Vertex vertex;
  };
  using EdgeCuts = std::map<double, TopoDS_Vertex>;  ///< by the edge's parameter

  double along(const gp_Pnt2d& uv) const { return is_u_ ? uv.Y() : uv.X(); }
  double place(const gp_Pnt2d& uv) const { return is_u_ ? uv.X() : uv.Y(); }
  double slack() const { return along_share * (curve_->LastParameter() - curve_->FirstParameter()); }

  /// How far (u, v) is beyond the curve, in the rows' direction.
  double beyond(const gp_Pnt2d& uv) const {
    const gp_Pnt2d at = curve_->Value(std::clamp(along(uv), curve_->FirstParameter(), curve_->LastParameter()));
    return place(uv) - place(at);
  }

  gp_Pnt point(const gp_Pnt2d& uv) const { return surface_.Value(uv.X(), uv.Y()); }

  std::map<double, double> through_vertices(const CutCurve& curve) {
    std::map<double, double> places = curve.places;
    if (curve.near <= 0) return places;
    curve_ = curve_through(places, is_u_);
    for (const TopoDS_Edge& use : uses_) {
      const EdgeImage image = image_of(use, face_);
      if (image.curve.IsNull()) continue;
      for (const double share : {0.0, 1.0}) {
        const gp_Pnt2d uv = image.uv(share);
        if (distance(uv) > curve.near) continue;
        const double margin = vertex_share * (places.rbegin()->first - places.begin()->first);
        places.erase(places.lower_bound(along(uv) - margin), places.upper_bound(along(uv) + margin));
        places[along(uv)] = place(uv);
      }
    }
    return places;
  }

  /// Where an edge runs along the curve, however near to it.
  bool is_on_border(double at) const {
    return std::ranges::any_of(on_border_, [&](const CurveRange& part) { return at > part.first && at < part.last; });
  }

  std::vector<Crossing> find_crossings() {
    std::vector<Crossing> crossings;
    on_border_.clear();
    for (const TopoDS_Edge& use : uses_) {
      const EdgeImage image = image_of(use, face_);
      if (image.curve.IsNull()) continue;
      const TopoDS_Edge edge = forward(use);
      TopoDS_Vertex first, last;
      TopExp::Vertices(edge, first, last);
      auto add = [&](double t, const TopoDS_Vertex& vertex) {
        crossings.push_back({along(image.curve->Value(t)), vertex});
      };
      const bool is_pole = BRep_Tool::Degenerated(edge);  // all of it is near to any curve that ends there
      for (const auto& [t, end] : {std::pair{image.first, first}, std::pair{image.last, last}})
        if (!is_pole && is_on_curve(image.curve->Value(t))) add(t, end);
      if (!is_pole && runs_along(image)) {
        const auto [low, high] = std::minmax({along(image.uv(0)), along(image.uv(1))});
        on_border_.push_back({low, high});
        continue;
      }
      for (int i = 0; i < edge_samples; ++i) {
        const double low = image.at(static_cast<double>(i) / edge_samples);
        const double high = image.at((i + 1.0) / edge_samples);
        const auto t = crossing(*image.curve, low, high);
        if (!t) continue;
        const gp_Pnt at = point(image.curve->Value(*t));
        auto is_at = [&](const TopoDS_Vertex& end) {
          const double believed = std::min(BRep_Tool::Tolerance(end), believed_share * diagonal_);
          return at.Distance(BRep_Tool::Pnt(end)) <= std::max(near_, believed);
        };
        add(*t, !is_pole && is_at(first) ? first : !is_pole && is_at(last) ? last : cut(edge, *t, first));
      }
    }
    std::ranges::sort(crossings, {}, &Crossing::along);
    const double range = curve_->LastParameter() - curve_->FirstParameter();
    const auto same = [&](const Crossing& a, const Crossing& b) {
      return b.along - a.along <= (a.vertex.IsSame(b.vertex) ? vertex_share : along_share) * range;
    };
    crossings.erase(std::unique(crossings.begin(), crossings.end(), same), crossings.end());
    return crossings;
  }

  bool runs_along(const EdgeImage& image) const {
    return std::ranges::all_of(std::array{0.0, 0.25, 0.5, 0.75, 1.0},
                               [&](double share) { return is_on_curve(image.uv(share)); });
  }

  bool is_on_curve(const gp_Pnt2d& uv) const { return distance(uv) <= near_; }

  /// From the curve, on the row.
  double distance(const gp_Pnt2d& uv) const {
    if (along(uv) < curve_->FirstParameter() - slack() || along(uv) > curve_->LastParameter() + slack())
      return std::numeric_limits<double>::infinity();
    return point(uv).Distance(
        point(is_u_ ? gp_Pnt2d(uv.X() - beyond(uv), uv.Y()) : gp_Pnt2d(uv.X(), uv.Y() - beyond(uv))));
  }

  std::optional<double> crossing(const Geom2d_Curve& image, double low, double high) const {
    const bool starts_below = beyond(image.Value(low)) < 0;
    if (starts_below == (beyond(image.Value(high)) < 0)) return std::nullopt;
    for (int i = 0; i < bisections; ++i) {
      const double middle = std::midpoint(low, high);
      ((beyond(image.Value(middle)) < 0) == starts_below ? low : high) = middle;
    }
    return std::midpoint(low, high);
  }

  /// At poles their vertex.
  TopoDS_Vertex cut(const TopoDS_Edge& edge, double t, const TopoDS_Vertex& pole) {
    auto entry = std::ranges::find_if(cuts_, [&](const auto& known) { return known.first.IsSame(edge); });
    if (entry == cuts_.end()) entry = cuts_.insert(entry, {edge, {}});
    if (BRep_Tool::Degenerated(edge)) return entry->second[t] = pole;
    const gp_Pnt at = BRepAdaptor_Curve(edge).Value(t);
    for (const auto& [other, vertex] : entry->second)
      if (BRep_Tool::Pnt(vertex).Distance(at) <= near_) return vertex;
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, at, BRep_Tool::Tolerance(edge));
    return entry->second[t] = vertex;
  }

  TopoDS_Edge inner_edge(const Crossing& from, const Crossing& to) const {
    TopoDS_Edge edge;
    BRep_Builder builder;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, curve_, face_, edge_tolerance);
    builder.Range(edge, from.along, to.along);
    builder.Add(edge, from.vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, to.vertex.Oriented(TopAbs_REVERSED));
    BRepLib::BuildCurve3d(edge, curve_share * diagonal_);
    for (const TopoDS_Vertex& end : {from.vertex, to.vertex}) builder.UpdateVertex(end, BRep_Tool::Tolerance(edge));
    return edge;
  }

  static std::vector<TopoDS_Edge> parts_of(const TopoDS_Edge& edge, const EdgeCuts& cuts) {
    TopoDS_Vertex start, last;
    TopExp::Vertices(edge, start, last);
    const auto [begin, end] = range_of(edge);
    double from = begin;
    std::vector<TopoDS_Edge> parts;
    auto add = [&](double to, const TopoDS_Vertex& vertex) {
      TopoDS_Edge part = TopoDS::Edge(edge.EmptyCopied());
      BRep_Builder builder;
      builder.Range(part, from, to);
      builder.Add(part, start.Oriented(TopAbs_FORWARD));
      builder.Add(part, vertex.Oriented(TopAbs_REVERSED));
      parts.push_back(part);
      from = to, start = vertex;
    };
    for (const auto& [t, vertex] : cuts) add(t, vertex);
    add(end, last);
    return parts;
  }

  static TopoDS_Wire wire_of(const std::vector<TopoDS_Edge>& parts) {
    BRep_Builder builder;
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Edge& part : parts) builder.Add(wire, part);
    return wire;
  }

  TopoDS_Shape faces_between(const TopTools_ListOfShape& edges) {
    BOPAlgo_BuilderFace faces;
    faces.SetFace(face_);
    faces.SetShapes(edges);
    faces.Perform();
    TopoDS_Compound pieces;
    BRep_Builder builder;
    builder.MakeCompound(pieces);
    for (const TopoDS_Shape& piece : faces.Areas()) builder.Add(pieces, with_own_surface(TopoDS::Face(piece)));
    return pieces;
  }

  /// On the part between the curves beside it, which may be smooth where the whole is not.
  TopoDS_Face with_own_surface(const TopoDS_Face& piece) {
    TopLoc_Location location;
    const Handle(Geom_Surface) whole = BRep_Tool::Surface(piece, location);
    const Handle(Geom_Surface) own = narrowed(whole, rows_of(piece));
    TopoDS_Face result;
    BRep_Builder builder;
    builder.MakeFace(result, own, location, BRep_Tool::Tolerance(piece));
    for (const TopoDS_Wire& wire : wires_of(piece)) builder.Add(result, wire);
    for (const TopoDS_Edge& edge : edges_of(piece)) {
      const EdgeImage image = image_of(edge, piece);
      if (image.curve.IsNull()) continue;
      const double tolerance = BRep_Tool::Tolerance(edge);
      if (use_count(edge, piece) > 1) {
        const EdgeImage other = image_of(TopoDS::Edge(edge.Reversed()), piece);
        const bool is_forward = edge.Orientation() == TopAbs_FORWARD;
        builder.UpdateEdge(edge, is_forward ? image.curve : other.curve, is_forward ? other.curve : image.curve, own,
                           location, tolerance);
      } else {
        builder.UpdateEdge(edge, image.curve, own, location, tolerance);
      }
      builder.Range(edge, own, location, image.first, image.last);
    }
    return result;
  }

  CurveRange range(bool is_u) const {
    return is_u ? CurveRange{surface_.FirstUParameter(), surface_.LastUParameter()}
                : CurveRange{surface_.FirstVParameter(), surface_.LastVParameter()};
  }

  /// From where to where the rows go between the curves beside a piece.
  CurveRange rows_of(const TopoDS_Face& piece) {
    CurveRange rows = range(is_u_);
    for (const Handle(Geom2d_BSplineCurve) & curve : curves_) {
      curve_ = curve;
      double farthest = 0;
      for (const TopoDS_Edge& edge : edges_of(piece)) {
        const EdgeImage image = image_of(edge, piece);
        if (image.curve.IsNull()) continue;
        for (const double share : {0.0, 0.5, 1.0})
          if (const double aside = beyond(image.uv(share)); std::abs(aside) > std::abs(farthest)) farthest = aside;
      }
      double low = place(curve->Pole(1)), high = low;
      for (int i = 2; i <= curve->NbPoles(); ++i)
        low = std::min(low, place(curve->Pole(i))), high = std::max(high, place(curve->Pole(i)));
      if (farthest < 0) rows.last = std::min(rows.last, high);
      if (farthest > 0) rows.first = std::max(rows.first, low);
    }
    return rows;
  }

  /// Whole where the face's images lie in another period.
  Handle(Geom_Surface) narrowed(const Handle(Geom_Surface) & surface, const CurveRange& rows) const {
    const auto own = Handle(Geom_Surface)::DownCast(untrimmed(surface)->Copy());
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
    own->Bounds(u0, u1, v0, v1);
    auto holds = [&](const CurveRange& inner, double first, double last) {
      const double slack = along_share * (inner.last - inner.first);
      return inner.first >= first - slack && inner.last <= last + slack;
    };
    if (!holds(range(true), u0, u1) || !holds(range(false), v0, v1)) return own;
    if (is_u_)
      u0 = std::max(u0, rows.first), u1 = std::min(u1, rows.last);
    else
      v0 = std::max(v0, rows.first), v1 = std::min(v1, rows.last);
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(own)) {
      spline->Segment(u0, u1, v0, v1);
      return own;
    }
    const double first = is_u_ ? u0 : v0, last = is_u_ ? u1 : v1;
    if (const auto swept = Handle(Geom_SweptSurface)::DownCast(own)) {
      const auto spline = Handle(Geom_BSplineCurve)::DownCast(untrimmed(swept->BasisCurve()));
      const bool is_along_curve = is_u_ == swept->IsKind(STANDARD_TYPE(Geom_SurfaceOfLinearExtrusion));
      if (!spline.IsNull() && is_along_curve) {
        spline->Segment(first, last);
        if (const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(own))
          extrusion->SetBasisCurve(spline);
        if (const auto revolution = Handle(Geom_SurfaceOfRevolution)::DownCast(own)) revolution->SetBasisCurve(spline);
        return own;
      }
    }
    return new Geom_RectangularTrimmedSurface(own, first, last, is_u_);
  }

  const TopoDS_Face& face_;
  BRepAdaptor_Surface surface_;
  bool is_u_;
  double diagonal_, near_;
  std::vector<TopoDS_Edge> uses_;
  std::vector<std::pair<TopoDS_Edge, EdgeCuts>> cuts_;
  std::vector<Handle(Geom2d_BSplineCurve)> curves_;
  std::vector<CurveRange> on_border_;  ///< of the curve that is being looked at
  Handle(Geom2d_BSplineCurve) curve_;  ///< the one that is being looked at
};

}  // namespace

Division divide_along(const TopoDS_Face& face, bool is_u, const std::vector<CutCurve>& curves, double diagonal) {
  return AlongDivider(face, is_u, diagonal).divide(curves);
}

}  // namespace paver
