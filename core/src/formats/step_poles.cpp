// 1. Of the file's loops: which edges a face uses twice, and which of them end where no other does, at a pole.
// 2. Where there are two: all other edges of the face that was read, chained to holes, their images without jumps.
// 3. The whole surface from pole to pole, its periodic edge where no hole is, and the holes in it.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <StepShape_Vertex.hxx>
#include <TopAbs.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "formats/step_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

constexpr int edge_samples = 16;
constexpr double jump_share = 1e-3;  // of the period: images that meet
constexpr double least_gap = 0.01;   // of the period: between holes, for the periodic edge
constexpr double pole_share = 1e-6;  // of the surface's size: a row so small is a pole

/// How many ends of edges that the face uses twice no other edge has: there they turn back at a pole.
int dead_ends(const StepShape_FaceSurface& face) {
  std::map<const Standard_Transient*, std::pair<Handle(StepShape_Edge), int>> uses;
  for (int b = 1; b <= face.NbBounds(); ++b) {
    const Handle(StepShape_EdgeLoop) loop = Handle(StepShape_EdgeLoop)::DownCast(face.BoundsValue(b)->Bound());
    for (int e = 1; !loop.IsNull() && e <= loop->NbEdgeList(); ++e) {
      const Handle(StepShape_Edge) edge = loop->EdgeListValue(e)->EdgeElement();
      if (!edge.IsNull()) uses[edge.get()].first = edge, ++uses[edge.get()].second;
    }
  }
  std::map<const Standard_Transient*, int> edges_at;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()}) ++edges_at[end.get()];
  int count = 0;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()})
      count += use.second == 2 && edges_at[end.get()] == 1;
  return count;
}

/// The face's surface, which repeats in u; null where it does not.
Handle(Geom_Surface) periodic_surface(const TopoDS_Face& face) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face, location));
  if (surface.IsNull() || !location.IsIdentity()) return nullptr;
  if (surface->IsUPeriodic()) return surface;
  const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull() || !spline->IsUClosed()) return nullptr;
  const auto periodic = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
  periodic->SetUPeriodic();
  return Handle(Geom_Surface)(periodic);
}

/// A closed chain of edges, each as it is walked, with images that meet.
struct Hole {
  std::vector<TopoDS_Edge> edges;
  std::vector<Handle(Geom2d_Curve)> images;
  std::vector<gp_Pnt2d> points;

  /// Of the images, round the surface.
  std::pair<double, double> range() const {
    auto less = [](const gp_Pnt2d& a, const gp_Pnt2d& b) { return a.X() < b.X(); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    return {low->X(), high->X()};
  }
};

Handle(Geom2d_Curve) moved_round(const Handle(Geom2d_Curve) & image, double by) {
  return Handle(Geom2d_Curve)::DownCast(image->Translated(gp_Vec2d(by, 0)));
}

class WholeFace {
 public:
  explicit WholeFace(const TopoDS_Face& read) : read_(forward(read)), surface_(periodic_surface(read_)) {
    if (surface_.IsNull()) return;
    double u0 = 0, u1 = 0;
    surface_->Bounds(u0, u1, v0_, v1_);
    period_ = u1 - u0;
  }

  /// Whether it has its poles, and lies within one period.
  bool was_read() const {
    int poles = 0;
    double low = INFINITY, high = -INFINITY;
    for (const TopoDS_Edge& edge : edges_of(read_)) {
      poles += BRep_Tool::Degenerated(edge);
      const EdgeImage image = image_of(edge, read_);
      for (int i = 0; !image.curve.IsNull() && i <= edge_samples; ++i) {
        const double u = image.curve->Value(image.first + (image.last - image.first) * i / edge_samples).X();
        low = std::min(low, u), high = std::max(high, u);
      }
    }
    return poles == 2 && high - low < (1 + jump_share) * period_;
  }

  /// Nothing where the surface has no pole at either end, or its edges form no holes.
  std::optional<TopoDS_Face> make() {
    if (surface_.IsNull() || !has_poles() || !find_holes()) return std::nullopt;
    const std::optional<double> start = find_start();
    if (!start) return std::nullopt;
    BRepBuilderAPI_MakeFace maker(surface_, *start, *start + period_, v0_, v1_, Precision::Confusion());
    if (!maker.IsDone()) return std::nullopt;
    TopoDS_Face face = maker.Face();
    for (const Hole& hole : holes_) BRep_Builder().Add(face, wire_of(hole, *start));
    return BRepCheck_Analyzer(face).IsValid() ? std::optional(face) : std::nullopt;
  }

 private:
  // At the ends of the surface; a spindle, whose meridian is a circle, has them elsewhere.
  bool has_poles() const {
    if (surface_->IsVPeriodic() || Precision::IsInfinite(v0_) || Precision::IsInfinite(v1_)) return false;
    auto extent = [&](double v) {
      const gp_Pnt at = surface_->Value(0, v);
      return std::max(at.Distance(surface_->Value(0.3 * period_, v)), at.Distance(surface_->Value(0.6 * period_, v)));
    };
    const double least = pole_share * std::max(extent(0.5 * (v0_ + v1_)), extent(0.3 * v0_ + 0.7 * v1_));
    return extent(v0_) < least && extent(v1_) < least;
  }

  // Vertices have two edges each: holes that touch are left as they were read.
  bool find_holes() {
    std::vector<TopoDS_Edge> left;
    for (const TopoDS_Edge& edge : edges_of(read_)) {
      if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, read_)) continue;
      if (image_of(edge, read_).curve.IsNull()) return false;
      auto is_same = [&](const TopoDS_Edge& other) { return other.IsSame(edge); };
      if (std::any_of(left.begin(), left.end(), is_same)) return false;  // a slit, which ends inside the face
      left.push_back(edge);
    }
    while (!left.empty()) {
      Hole hole;
      const TopoDS_Vertex start = TopExp::FirstVertex(left.back());
      TopoDS_Vertex at = start;
      do {
        auto leads_on = [&](const TopoDS_Edge& edge) {
          return TopExp::FirstVertex(edge).IsSame(at) || TopExp::LastVertex(edge).IsSame(at);
        };
        const auto next = std::find_if(left.rbegin(), left.rend(), leads_on);
        if (next == left.rend()) return false;
        const bool is_forward = TopExp::FirstVertex(*next).IsSame(at);
        if (!walk(*next, is_forward, hole)) return false;
        at = is_forward ? TopExp::LastVertex(*next) : TopExp::FirstVertex(*next);
        left.erase(std::next(next).base());
      } while (!at.IsSame(start));
      if (std::fabs(hole.points.back().X() - hole.points.front().X()) > jump_share * period_) return false;
      holes_.push_back(std::move(hole));
    }
    return !holes_.empty();
  }

  // Moves the edge's image by periods to where the one before ends.
  bool walk(const TopoDS_Edge& edge, bool is_forward, Hole& hole) {
    EdgeImage image = image_of(edge, read_);
    const gp_Pnt2d from = image.curve->Value(is_forward ? image.first : image.last);
    const double gap = hole.points.empty() ? 0 : hole.points.back().X() - from.X();
    const double by = period_ * std::round(gap / period_);
    if (std::fabs(gap - by) > jump_share * period_) return false;
    image.curve = moved_round(image.curve, by);
    for (int i = 0; i <= edge_samples; ++i) {
      const double share = static_cast<double>(is_forward ? i : edge_samples - i) / edge_samples;
      hole.points.push_back(image.curve->Value((1 - share) * image.first + share * image.last));
    }
    hole.images.push_back(image.curve);
    hole.edges.push_back(TopoDS::Edge(edge.Oriented(is_forward ? TopAbs_FORWARD : TopAbs_REVERSED)));
    return true;
  }

  /// The middle of the widest gap between holes.
  std::optional<double> find_start() const {
    std::vector<std::pair<double, double>> taken;
    for (const Hole& hole : holes_) {
      const auto [low, high] = hole.range();
      const double down = period_ * std::floor(low / period_);
      taken.push_back({low - down, high - down});
    }
    std::sort(taken.begin(), taken.end());
    double reach = 0, widest = least_gap * period_;
    for (const auto& [low, high] : taken) reach = std::max(reach, high - period_);
    std::optional<double> start;
    taken.push_back({period_ + taken.front().first, 0});
    for (const auto& [low, high] : taken) {
      if (low - reach > widest) widest = low - reach, start = 0.5 * (low + reach);
      reach = std::max(reach, high);
    }
    return start ? std::optional(*start - period_ * std::floor(*start / period_)) : start;
  }

  // Clockwise in the surface's parameters: what it cuts out is on the right.
  TopoDS_Wire wire_of(const Hole& hole, double start) const {
    const double by = -period_ * std::floor((hole.range().first - start) / period_);
    double area = 0;
    for (std::size_t i = 0; i < hole.points.size(); ++i)
      area += hole.points[i].XY().Crossed(hole.points[(i + 1) % hole.points.size()].XY());
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    for (std::size_t i = 0; i < hole.edges.size(); ++i) {
      const TopoDS_Edge& edge = hole.edges[i];
      builder.UpdateEdge(edge, moved_round(hole.images[i], by), surface_, TopLoc_Location(),
                         BRep_Tool::Tolerance(edge));
      builder.Add(wire, edge);
    }
    wire.Closed(true);
    return TopoDS::Wire(wire.Oriented(area < 0 ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  TopoDS_Face read_;
  Handle(Geom_Surface) surface_;
  double v0_ = 0, v1_ = 0, period_ = 0;
  std::vector<Hole> holes_;
};

/// Nothing where the face was read as it is, or the kernel fails on it.
std::optional<TopoDS_Face> whole_face(const TopoDS_Face& read) {
  try {
    WholeFace maker(read);
    return maker.was_read() ? std::nullopt : maker.make();
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace

void restore_poles(XSControl_Reader& reader, Shape& shape) {
  const auto faces = shapes_of(shape.shape, TopAbs_FACE);
  BRepTools_ReShape change;
  change.ModeConsiderLocation() = true;  // parts may stand in several places
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto entity = Handle(StepShape_FaceSurface)::DownCast(any);
    if (entity.IsNull() || dead_ends(*entity) != 2) continue;
    for (const TopoDS_Face& read : faces_of(shape_of(reader, entity))) {
      const std::optional<TopoDS_Face> whole = whole_face(read);
      if (!whole) continue;
      // The reader may have turned the face over with its loop.
      const TopAbs_Orientation sense = entity->SameSense() ? TopAbs_FORWARD : TopAbs_REVERSED;
      for (int k = 1; k <= faces.Extent(); ++k) {
        if (!faces(k).IsPartner(read)) continue;
        const TopAbs_Orientation turn = TopAbs::Compose(faces(k).Orientation(), read.Orientation());
        change.Replace(faces(k), whole->Located(faces(k).Location()).Oriented(TopAbs::Compose(sense, turn)));
        shape.restored.push_back(k - 1);
      }
    }
  }
  if (!shape.restored.empty()) shape.shape = change.Apply(shape.shape);
}

}  // namespace paver
