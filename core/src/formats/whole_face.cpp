// 1. All edges of what was read, chained to loops, their images without jumps.
// 2. Where a loop goes round the surface or through poles: a face of these loops. Else the whole surface, from pole to
//    pole or all round, its periodic edges where no hole is, and the holes in it.
#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TopAbs.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "brep/occt_shapes_impl.h"
#include "formats/whole_face_impl.h"

namespace paver {
namespace {

constexpr int edge_samples = 16;
constexpr double jump_share = 1e-3;  // of the period: images that meet
constexpr double least_gap = 0.01;   // of the period: between holes, for the periodic edge
constexpr double pole_share = 1e-6;  // of the surface's size: a row so small is a pole

/// What a border runs along at a pole, where its images jump.
struct PoleWay {
  double from = 0, to = 0, v = 0;  // u
  /// Where a periodic edge leads to the other pole, as that lies in the face, too: its u, and the period by which what
  /// comes behind it lies lower.
  std::optional<double> side{};
  double round = 0;
};

/// An edge of a face, as that walks it.
struct Walk {
  TopoDS_Edge edge;
  EdgeImage image;
  std::optional<PoleWay> pole{};  ///< at which it begins
};

/// A closed chain of edges, each as it is walked, with images that meet.
struct Loop {
  std::vector<Walk> walks;
  std::vector<gp_Pnt2d> points;  ///< `samples` of each

  static constexpr std::size_t samples = edge_samples + 1;

  const gp_Pnt2d& start(std::size_t walk) const { return points[walk * samples]; }
  const gp_Pnt2d& end(std::size_t walk) const { return points[(walk + 1) * samples - 1]; }

  std::vector<TopoDS_Edge> edges() const {
    std::vector<TopoDS_Edge> walked;
    for (const Walk& walk : walks) walked.push_back(walk.edge);
    return walked;
  }

  bool has_pole() const {
    return std::ranges::any_of(walks, [](const Walk& walk) { return walk.pole.has_value(); });
  }

  double length(int axis) const { return points.back().Coord(axis) - points.front().Coord(axis); }

  /// Of the images, along u (1) or v (2).
  std::pair<double, double> range(int axis) const {
    auto less = [axis](const gp_Pnt2d& a, const gp_Pnt2d& b) { return a.Coord(axis) < b.Coord(axis); };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    return {low->Coord(axis), high->Coord(axis)};
  }

  double area() const {
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      area += points[i].XY().Crossed(points[(i + 1) % points.size()].XY());
    return area;
  }
};

class FaceMaker {
 public:
  explicit FaceMaker(const std::vector<TopoDS_Face>& read) : read_(read), surface_(periodic_surface(read_.front())) {
    if (surface_.IsNull()) return;
    double u1 = 0;
    surface_->Bounds(start_[0], u1, start_[1], v1_);
    period_[0] = u1 - start_[0];
    if (surface_->IsVPeriodic()) period_[1] = v1_ - start_[1];
  }

  std::optional<TopoDS_Face> make(const std::vector<FileEdge>& file) {
    if (surface_.IsNull() || !find_loops()) return std::nullopt;
    const bool has_pole = std::ranges::any_of(loops_, &Loop::has_pole);
    if (has_pole && (loops_.size() > 1 || !run_along_poles(loops_.front(), file))) return std::nullopt;
    const bool goes_round = std::any_of(loops_.begin(), loops_.end(), [](const Loop& loop) {
      return std::fabs(loop.length(1)) > 1 || std::fabs(loop.length(2)) > 1;
    });
    TopoDS_Face face;
    if (goes_round || has_pole) {
      BRep_Builder().MakeFace(face, surface_, Precision::Confusion());
    } else {
      if (!may_be_whole() || !find_start(0) || (period_[1] > 0 && !find_start(1))) return std::nullopt;
      const double v1 = period_[1] > 0 ? start_[1] + period_[1] : v1_;
      BRepBuilderAPI_MakeFace maker(surface_, start_[0], start_[0] + period_[0], start_[1], v1, Precision::Confusion());
      if (!maker.IsDone()) return std::nullopt;
      face = maker.Face();
    }
    for (const Loop& loop : loops_) BRep_Builder().Add(face, wire_of(loop, !goes_round && !has_pole, file));
    return (goes_round && !has_pole) || BRepCheck_Analyzer(face).IsValid() ? std::optional(face) : std::nullopt;
  }

  bool may_be_whole() const { return !surface_.IsNull() && (period_[1] > 0 || has_poles()); }

  // At the ends of the surface; a spindle, whose meridian is a circle, has them elsewhere.
  bool has_poles() const {
    if (surface_.IsNull() || Precision::IsInfinite(start_[1]) || Precision::IsInfinite(v1_)) return false;
    auto extent = [&](double v) {
      const gp_Pnt at = surface_->Value(0, v);
      return std::max(at.Distance(surface_->Value(0.3 * period_[0], v)),
                      at.Distance(surface_->Value(0.6 * period_[0], v)));
    };
    const double least = pole_share * std::max(extent(0.5 * (start_[1] + v1_)), extent(0.3 * start_[1] + 0.7 * v1_));
    return extent(start_[1]) < least && extent(v1_) < least;
  }

 private:
  // Vertices have two edges each: holes that touch are left as they were read.
  bool find_loops() {
    std::vector<Walk> left;
    for (const TopoDS_Face& face : read_)
      for (const TopoDS_Edge& edge : edges_of(face)) {
        if (BRep_Tool::Degenerated(edge)) TopExp::MapShapes(edge, TopAbs_VERTEX, at_poles_);
        if (BRep_Tool::Degenerated(edge) || BRep_Tool::IsClosed(edge, face)) continue;
        const EdgeImage image = image_of(edge, face);
        if (image.curve.IsNull()) return false;
        auto is_same = [&](const Walk& other) { return other.edge.IsSame(edge); };
        if (std::any_of(left.begin(), left.end(), is_same)) return false;  // a slit, which ends inside the face
        left.push_back({edge, image});
      }
    while (!left.empty()) {
      Loop loop;
      const TopoDS_Vertex start = TopExp::FirstVertex(left.back().edge);
      TopoDS_Vertex at = start;
      do {
        auto leads_on = [&](const Walk& walk) {
          return are_one(TopExp::FirstVertex(walk.edge), at) || are_one(TopExp::LastVertex(walk.edge), at);
        };
        const auto next = std::find_if(left.rbegin(), left.rend(), leads_on);
        if (next == left.rend()) return false;
        const bool is_forward = are_one(TopExp::FirstVertex(next->edge), at);
        if (!walk(*next, is_forward, loop)) return false;
        at = is_forward ? TopExp::LastVertex(next->edge) : TopExp::FirstVertex(next->edge);
        left.erase(std::next(next).base());
      } while (!are_one(at, start));
      if (jumps_at_pole(loop.points.back(), loop.points.front())) loop.walks.front().pole = PoleWay{};
      for (int axis : {1, 2})
        if (!loop.has_pole() && !shift_of(loop.length(axis), period_[axis - 1])) return false;
      loops_.push_back(std::move(loop));
    }
    return !loops_.empty();
  }

  /// At a pole the border may have several vertices, with edges of no length between.
  bool are_one(const TopoDS_Vertex& a, const TopoDS_Vertex& b) const {
    if (a.IsSame(b)) return true;
    const double near = BRep_Tool::Tolerance(a) + BRep_Tool::Tolerance(b);
    return at_poles_.Contains(a) && at_poles_.Contains(b) && BRep_Tool::Pnt(a).Distance(BRep_Tool::Pnt(b)) < near;
  }

  /// The whole periods that a gap is; nothing where it is none.
  static std::optional<double> shift_of(double gap, double period) {
    const double by = period > 0 ? period * std::round(gap / period) : 0;
    if (period > 0 && std::fabs(gap - by) > jump_share * period) return std::nullopt;
    return by;
  }

  bool jumps_at_pole(const gp_Pnt2d& from, const gp_Pnt2d& to) const {
    if (period_[1] > 0 || shift_of(to.X() - from.X(), period_[0])) return false;
    const double near = jump_share * (v1_ - start_[1]);
    for (const double v : {start_[1], v1_})
      if (std::fabs(from.Y() - v) < near && std::fabs(to.Y() - v) < near) return has_poles();
    return false;
  }

  // At a pole a border runs on with the face to its left: down in u along the upper end, up along the lower one. Moves
  // all images so; whether they close then, if need be with a way to the other pole and back.
  bool run_along_poles(Loop& loop, const std::vector<FileEdge>& file) const {
    const bool is_along = agreement(loop.edges(), file) >= 0;
    const double period = period_[0];
    double by = 0, last = loop.points.back().X();
    for (std::size_t i = 0; i < loop.walks.size(); ++i) {
      Walk& walk = loop.walks[i];
      const gp_Pnt2d start = loop.start(i);
      if (walk.pole && i > 0) {
        const double way = start.X() + by - last;
        by += (is_down(start, is_along) ? period * std::floor(-way / period) : period * std::ceil(-way / period));
      }
      if (walk.pole) walk.pole = PoleWay{last, start.X() + by, start.Y()};
      move(loop, i, by);
      last = loop.end(i).X();
    }
    const gp_Pnt2d& start = loop.points.front();
    const bool is_pole = loop.walks.front().pole.has_value();
    if (is_pole) loop.walks.front().pole->from = last;
    const double way = start.X() - last;
    if (is_pole ? std::fabs(way) < period && (way < 0) == is_down(start, is_along) : shift_of(way, period) == 0.0)
      return true;
    return lead_to_other_pole(loop, is_along);
  }

  /// Of a loop that goes round with what it runs along at its pole. From there, where the loop is farthest.
  bool lead_to_other_pole(Loop& loop, bool is_along) const {
    constexpr int places = 16;
    const auto at = std::ranges::find_if(loop.walks, [](const Walk& walk) { return walk.pole.has_value(); });
    const auto first = static_cast<std::size_t>(at - loop.walks.begin());
    PoleWay& pole = *at->pole;
    pole.round = is_down(loop.start(first), is_along) ? -period_[0] : period_[0];
    if (first == 0) pole.to += pole.round;
    const double way = pole.to - pole.from;
    if (way * pole.round <= 0 || std::fabs(way) > period_[0]) return false;
    double widest = 0;
    for (int i = 1; i < places; ++i) {
      const double u = pole.from + way * i / places;
      double gap = period_[0];
      for (const gp_Pnt2d& point : loop.points)
        gap = std::min(gap, std::fabs(std::remainder(point.X() - u, period_[0])));
      if (gap > widest) widest = gap, pole.side = u;
    }
    pole.to -= pole.round;
    for (std::size_t i = first; first > 0 && i < loop.walks.size(); ++i) {
      move(loop, i, -pole.round);
      if (std::optional<PoleWay>& later = loop.walks[i].pole; later && i > first)
        later->from -= pole.round, later->to -= pole.round;
    }
    return widest > 0 && (first == 0 || shift_of(loop.length(1), period_[0]) == 0.0);
  }

  /// The image of one of its edges, along u.
  static void move(Loop& loop, std::size_t i, double by) {
    loop.walks[i].image.curve = moved(loop.walks[i].image.curve, {by, 0});
    for (std::size_t k = 0; k < Loop::samples; ++k) {
      gp_Pnt2d& point = loop.points[i * Loop::samples + k];
      point.SetX(point.X() + by);
    }
  }

  bool is_down(const gp_Pnt2d& pole, bool is_along) const {
    return (std::fabs(pole.Y() - v1_) < std::fabs(pole.Y() - start_[1])) == is_along;
  }

  // Moves the edge's image by periods to where the one before ends.
  bool walk(Walk walk, bool is_forward, Loop& loop) {
    const EdgeImage& image = walk.image;
    const gp_Pnt2d from = image.curve->Value(is_forward ? image.first : image.last);
    const gp_Vec2d gap = loop.points.empty() ? gp_Vec2d() : gp_Vec2d(from, loop.points.back());
    const std::optional<double> u = shift_of(gap.X(), period_[0]), v = shift_of(gap.Y(), period_[1]);
    if (!loop.points.empty() && jumps_at_pole(loop.points.back(), from)) walk.pole = PoleWay{};
    if (!v || (!u && !walk.pole)) return false;
    walk.image.curve = moved(image.curve, {u.value_or(0), *v});
    for (int i = 0; i <= edge_samples; ++i) {
      const double share = static_cast<double>(is_forward ? i : edge_samples - i) / edge_samples;
      loop.points.push_back(walk.image.curve->Value((1 - share) * image.first + share * image.last));
    }
    walk.edge.Orientation(is_forward ? TopAbs_FORWARD : TopAbs_REVERSED);
    loop.walks.push_back(std::move(walk));
    return true;
  }

  static Handle(Geom2d_Curve) moved(const Handle(Geom2d_Curve) & image, const gp_Vec2d& by) {
    return Handle(Geom2d_Curve)::DownCast(image->Translated(by));
  }

  /// The middle of the widest gap between loops along u (0) or v (1).
  bool find_start(int axis) {
    const double period = period_[axis];
    std::vector<std::pair<double, double>> taken;
    for (const Loop& loop : loops_) {
      const auto [low, high] = loop.range(axis + 1);
      const double down = period * std::floor(low / period);
      taken.push_back({low - down, high - down});
    }
    std::sort(taken.begin(), taken.end());
    double reach = 0, widest = least_gap * period;
    for (const auto& [low, high] : taken) reach = std::max(reach, high - period);
    std::optional<double> start;
    taken.push_back({period + taken.front().first, 0});
    for (const auto& [low, high] : taken) {
      if (low - reach > widest) widest = low - reach, start = 0.5 * (low + reach);
      reach = std::max(reach, high);
    }
    if (start) start_[axis] = *start - period * std::floor(*start / period);
    return start.has_value();
  }

  /// Of the way from the edge before to where the walk begins.
  void add_pole(const TopoDS_Edge& before, const Walk& walk, bool is_right, TopoDS_Wire& wire) const {
    BRep_Builder builder;
    const PoleWay& pole = *walk.pole;
    const TopoDS_Vertex here = TopExp::LastVertex(before, true), next = TopExp::FirstVertex(walk.edge, true);
    if (!pole.side) {
      builder.Add(wire, pole_edge(here, next, pole.from, pole.to, pole.v));
      return;
    }
    const double behind = *pole.side - pole.round;
    const bool is_up = std::fabs(pole.v - start_[1]) < std::fabs(pole.v - v1_);
    const double other = is_up ? v1_ : start_[1];
    TopoDS_Vertex there;
    builder.MakeVertex(there, surface_->Value(*pole.side, other), Precision::Confusion());
    const TopoDS_Edge side = side_edge(pole, is_up ? here : there, is_up ? there : here, is_up == is_right);
    builder.Add(wire, pole_edge(here, here, pole.from, *pole.side, pole.v));
    builder.Add(wire, side.Oriented(is_up ? TopAbs_FORWARD : TopAbs_REVERSED));
    builder.Add(wire, pole_edge(there, there, *pole.side, behind, other));
    builder.Add(wire, side.Oriented(is_up ? TopAbs_REVERSED : TopAbs_FORWARD));
    builder.Add(wire, pole_edge(here, next, behind, pole.to, pole.v));
  }

  TopoDS_Edge pole_edge(const TopoDS_Vertex& start, const TopoDS_Vertex& end, double from, double to, double v) const {
    BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.UpdateEdge(edge, new Geom2d_Line({from, v}, {to > from ? 1.0 : -1.0, 0}), surface_, TopLoc_Location(),
                       Precision::Confusion());
    builder.Degenerated(edge, true);
    builder.Add(edge, start.Oriented(TopAbs_FORWARD));
    builder.Add(edge, end.Oriented(TopAbs_REVERSED));
    builder.Range(edge, 0, std::fabs(to - from));
    return edge;
  }

  /// The periodic edge from pole to pole; the face has it upwards where it is walked first, or downwards.
  TopoDS_Edge side_edge(const PoleWay& pole, const TopoDS_Vertex& low, const TopoDS_Vertex& high, bool is_up) const {
    BRep_Builder builder;
    TopoDS_Edge edge;
    const double first = *pole.side, second = first - pole.round;
    auto line = [](double u) { return Handle(Geom2d_Line)(new Geom2d_Line({u, 0}, {0, 1})); };
    builder.MakeEdge(edge, surface_->UIso(first), Precision::Confusion());
    builder.UpdateEdge(edge, line(is_up ? first : second), line(is_up ? second : first), surface_, TopLoc_Location(),
                       Precision::Confusion());
    builder.Add(edge, low.Oriented(TopAbs_FORWARD));
    builder.Add(edge, high.Oriented(TopAbs_REVERSED));
    builder.Range(edge, start_[1], v1_);
    return edge;
  }

  // Clockwise in the surface's parameters where the file does not tell: what a hole cuts out is on the right.
  TopoDS_Wire wire_of(const Loop& loop, bool is_hole, const std::vector<FileEdge>& file) const {
    double by[2] = {0, 0};
    for (int axis : {0, 1})
      if (is_hole && period_[axis] > 0)
        by[axis] = -period_[axis] * std::floor((loop.range(axis + 1).first - start_[axis]) / period_[axis]);
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    const bool is_right = file.empty() ? loop.area() < 0 : agreement(loop.edges(), file) >= 0;
    const TopoDS_Edge* before = &loop.walks.back().edge;
    for (const Walk& walk : loop.walks) {
      if (walk.pole) add_pole(*before, walk, is_right, wire);
      before = &walk.edge;
      builder.UpdateEdge(walk.edge, moved(walk.image.curve, {by[0], by[1]}), surface_, TopLoc_Location(),
                         BRep_Tool::Tolerance(walk.edge));
      builder.Add(wire, walk.edge);
    }
    wire.Closed(true);
    return TopoDS::Wire(wire.Oriented(is_right ? TopAbs_FORWARD : TopAbs_REVERSED));
  }

  const std::vector<TopoDS_Face>& read_;
  Handle(Geom_Surface) surface_;
  double start_[2] = {0, 0}, period_[2] = {0, 0}, v1_ = 0;  // per u and v; 0: does not repeat
  std::vector<Loop> loops_;
  TopTools_IndexedMapOfShape at_poles_;  // vertices
};

}  // namespace

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

int agreement(const std::vector<TopoDS_Edge>& edges, const std::vector<FileEdge>& file) {
  int sum = 0;
  for (const TopoDS_Edge& edge : edges) {
    const BRepAdaptor_Curve curve(edge);
    gp_Pnt middle;
    gp_Vec way;
    curve.D1(0.5 * (curve.FirstParameter() + curve.LastParameter()), middle, way);
    double nearest = std::numeric_limits<double>::infinity(), along = 0;
    for (const FileEdge& other : file)
      for (std::size_t i = 0; i < other.places.size(); ++i)
        if (const double gap = middle.SquareDistance(other.places[i]); gap < nearest)
          nearest = gap, along = way.Dot(other.ways[i]);
    if (edge.Orientation() == TopAbs_REVERSED) along = -along;
    sum += along > 0 ? 1 : along < 0 ? -1 : 0;
  }
  return sum;
}

FileEdge file_edge(const TopoDS_Edge& edge, bool is_along_curve) {
  FileEdge walked;
  if (edge.IsNull() || BRep_Tool::Degenerated(edge)) return walked;
  const BRepAdaptor_Curve curve(edge);
  for (int i = 0; i <= 2 * edge_samples; ++i) {
    const double share = 0.5 * i / edge_samples;
    gp_Pnt place;
    gp_Vec way;
    curve.D1((1 - share) * curve.FirstParameter() + share * curve.LastParameter(), place, way);
    walked.places.push_back(place);
    walked.ways.push_back(is_along_curve ? way : -way);
  }
  return walked;
}

bool has_two_poles(const TopoDS_Face& face) { return FaceMaker({face}).has_poles(); }

bool may_be_whole(const std::vector<TopoDS_Face>& read) { return FaceMaker(read).may_be_whole(); }

std::optional<TopoDS_Face> make_whole_face(const std::vector<TopoDS_Face>& read, const std::vector<FileEdge>& walked) {
  try {
    return FaceMaker(read).make(walked);
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

}  // namespace paver
