// Faces that lack their pole: one loop goes once round a period, and nothing ends the face on its other side. Files
// have them where a pole lies inside the surface's range, as readers look for poles at its ends only.
// 1. The loop that goes round, without a periodic edge that may lead from it to where the pole should be.
// 2. The pole: across from the loop, on the side where the face lies, the first line round the surface that is a point.
// 3. The face anew, on the same surface: loop, periodic edge to the pole, pole, periodic edge back. The periodic edge
//    starts at a vertex of the loop and meets neither the loop nor a hole.
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/search/golden_section.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// A pole reaches no farther than this share of the diagonal.
constexpr double pole_share = 1e-6;
/// Sums of images that go round are whole periods up to this share of one.
constexpr double round_share = 1e-2;
constexpr int edge_samples = 32;
constexpr int row_samples = 16;
/// Rows that are looked at for a pole, over a finite range, and over one without end;
constexpr int finite_rows = 256, endless_rows = 96;
/// there each is so much farther away than the one before.
constexpr double row_growth = 1.2;
/// A row may be near a pole where it extends no farther than this share of its larger neighbour.
constexpr double drop_share = 0.75;
constexpr int section_steps = 90;
/// Crossings nearer to the ends of a periodic edge than this share of it are its ends.
constexpr double end_share = 1e-6;

/// An edge as a loop walks it; `points` of its image: x round the surface, y across.
struct Walk {
  TopoDS_Edge edge;
  TopoDS_Vertex from, to;
  std::vector<Vec2> points;
};

using Walks = std::vector<Walk>;

class PoleCompleter {
 public:
  PoleCompleter(const TopoDS_Face& face, double diagonal) : face_(face), tolerance_(pole_share * diagonal) {}

  /// Finds the loop that goes round, false where there is none, or where it does not lack its other end.
  bool find_loop() {
    surface_ = make_surface(face_, closure_tolerance());
    if (!surface_ || surface_->period() == Vec2{}) return false;
    for (const TopoDS_Wire& wire : wires_of(face_))
      if (!add_loop(wire)) return false;
    if (round_.empty()) return false;
    turn_to_axes();
    return true;
  }

  /// Of the loop that goes round.
  TopoDS_Edge first_edge() const { return round_.front().edge; }

  std::optional<CompletedFace> complete() {
    // What else is walked both ways lies inside the face.
    auto is_periodic = [&](const Walk& walk) { return BRep_Tool::IsClosed(walk.edge, face_); };
    if (!std::all_of(periodic_.begin(), periodic_.end(), is_periodic)) return std::nullopt;
    if (!find_pole() || !holds_holes()) return std::nullopt;
    const std::optional<double> across = shift_across();
    if (!across) return std::nullopt;
    if (const auto start = find_start()) return build(*start, *across);
    if (!periodic_.empty() || *across != 0) return std::nullopt;
    return with_pole_alone();
  }

 private:
  double closure_tolerance() const {
    double tolerance = 0;
    for (const TopoDS_Edge& edge : edges_of(face_)) tolerance = std::max(tolerance, 2 * BRep_Tool::Tolerance(edge));
    return tolerance;
  }

  /// False for loops that cannot be read, and for what is not one loop round and holes.
  bool add_loop(const TopoDS_Shape& wire) {
    Walks walks;
    bool is_whole = true;
    auto add = [&](const TopoDS_Edge& edge, const TopoDS_Vertex& first, const TopoDS_Vertex& last) {
      Walk walk{edge, first, last, image_points(edge)};
      is_whole = is_whole && !walk.points.empty() && !BRep_Tool::Degenerated(edge);
      walks.push_back(std::move(walk));
    };
    if (!visit_border(wire, add) || !is_whole) return false;
    Walks periodic = take_periodic(walks);
    if (!chain(walks)) return false;
    Vec2 sum;
    for (const Walk& walk : walks) sum = sum + (walk.points.back() - walk.points.front());
    const auto turns_u = turns(sum.x, surface_->period().x), turns_v = turns(sum.y, surface_->period().y);
    if (!turns_u || !turns_v) return false;
    if (*turns_u == 0 && *turns_v == 0) {
      for (const Walk& walk : walks) holes_.push_back(walk.points);
      return periodic.empty();
    }
    if (!round_.empty() || std::abs(*turns_u) + std::abs(*turns_v) != 1) return false;
    is_round_u_ = *turns_u != 0;
    turn_ = *turns_u + *turns_v;
    round_ = std::move(walks);
    periodic_ = std::move(periodic);
    wire_ = wire;
    return true;
  }

  /// As the loop walks it; none without an image.
  std::vector<Vec2> image_points(const TopoDS_Edge& edge) const {
    const EdgeImage image = image_of(edge, face_);
    std::vector<Vec2> points;
    if (image.curve.IsNull() || !image.is_finite()) return points;
    for (int i = 0; i <= edge_samples; ++i) {
      const gp_Pnt2d uv = image.curve->Value(image.first + (image.last - image.first) * i / edge_samples);
      points.push_back({uv.X(), uv.Y()});
    }
    if (edge.Orientation() == TopAbs_REVERSED) std::reverse(points.begin(), points.end());
    return points;
  }

  /// Moves edges that the loop walks both ways out of `walks`.
  static Walks take_periodic(Walks& walks) {
    auto is_twice = [&](const Walk& walk) {
      return std::count_if(walks.begin(), walks.end(),
                           [&](const Walk& other) { return other.edge.IsSame(walk.edge); }) > 1;
    };
    Walks once, twice;
    for (const Walk& walk : walks) (is_twice(walk) ? twice : once).push_back(walk);
    walks = std::move(once);
    return twice;
  }

  /// Puts edges one behind the other; false where that gives no closed loop of all.
  static bool chain(Walks& walks) {
    if (walks.empty()) return false;
    for (std::size_t i = 1; i < walks.size(); ++i) {
      auto follows = [&](const Walk& walk) { return walk.from.IsSame(walks[i - 1].to); };
      const auto next = std::find_if(walks.begin() + static_cast<std::ptrdiff_t>(i), walks.end(), follows);
      if (next == walks.end()) return false;
      std::rotate(walks.begin() + static_cast<std::ptrdiff_t>(i), next, next + 1);
    }
    return walks.back().to.IsSame(walks.front().from);
  }

  /// How often round; nothing where that is no whole number.
  static std::optional<int> turns(double sum, double period) {
    if (period <= 0) return 0;
    const double exact = sum / period, whole = std::round(exact);
    if (std::abs(exact - whole) > round_share) return std::nullopt;
    return static_cast<int>(whole);
  }

  void turn_to_axes() {
    auto turn = [&](std::vector<Vec2>& points) {
      for (Vec2& p : points) p = turned(p);
    };
    for (Walk& walk : round_) turn(walk.points);
    for (std::vector<Vec2>& hole : holes_) turn(hole);
    period_ = turned(surface_->period());
    // Left of u, along which the face lies to the left, is v; left of v is -u.
    side_ = is_round_u_ ? turn_ : -turn_;
    const std::vector<Vec2> shifts = shifts_from(0);
    low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
    for (std::size_t i = 0; i < round_.size(); ++i)
      for (const Vec2& p : round_[i].points) {
        low_ = std::min(low_, side_ * (p + shifts[i]).y);
        high_ = std::max(high_, side_ * (p + shifts[i]).y);
      }
  }

  /// (round, across) of (u, v), and back.
  Vec2 turned(Vec2 p) const { return is_round_u_ ? p : Vec2{p.y, p.x}; }

  Vec3 at(double round, double across) const { return surface_->point(turned({round, across})); }

  /// How far the row `reach` across, on the face's side, extends.
  double extent(double reach) const {
    const double across = side_ * reach, start = round_.front().points.front().x;
    const Vec3 first = at(start, across);
    double most = 0;
    for (int i = 1; i < row_samples; ++i)
      most = std::max(most, norm(at(start + period_.x * i / row_samples, across) - first));
    return most;
  }

  /// Where rows are looked at, from the loop on.
  std::vector<double> rows() const {
    std::array<double, 4> bounds{};
    geometry()->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
    const std::size_t low = is_round_u_ ? 2 : 0;
    const double end = period_.y > 0 ? low_ + period_.y : side_ > 0 ? bounds[low + 1] : -bounds[low];
    std::vector<double> list;
    if (!Precision::IsInfinite(end)) {
      for (int i = 0; i <= finite_rows; ++i) list.push_back(high_ + (end - high_) * i / finite_rows);
      return list;
    }
    const SurfaceSlope slope = surface_->slope(turned({round_.front().points.front().x, side_ * high_}));
    const double speed = norm(is_round_u_ ? slope.v : slope.u);
    double step = speed > 0 ? extent(high_) / (endless_rows * speed) : 1;
    for (int i = 0; i < endless_rows; ++i, step *= row_growth)
      list.push_back(list.empty() ? high_ : list.back() + step);
    return list;
  }

  bool find_pole() {
    const std::vector<double> reaches = rows();
    if (!(reaches.back() > high_)) return false;
    std::vector<double> extents;
    for (double reach : reaches) extents.push_back(extent(reach));
    const std::size_t last = reaches.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, last);
      if (extents[i] > extents[before] || extents[i] > extents[after]) continue;
      const bool is_inside = i > 0 && i < last;
      if (is_inside && extents[i] > drop_share * std::max(extents[before], extents[after])) continue;
      pole_ = smallest(reaches[before], reaches[after]);
      if (extents[i] <= extent(pole_)) pole_ = reaches[i];
      if (pole_ > high_ && extent(pole_) <= tolerance_) return true;
    }
    return false;
  }

  /// Where the extent is smallest.
  double smallest(double low, double high) const {
    return golden_section(low, high, section_steps, [&](double reach) { return extent(reach); }).best();
  }

  /// Holes beyond the pole say that the face does not end there.
  bool holds_holes() const {
    for (const std::vector<Vec2>& hole : holes_)
      for (const Vec2& p : hole)
        if (!(reach_of(p.y) < pole_)) return false;
    return true;
  }

  /// A value across as reach from the loop on; the loop's own stay below.
  double reach_of(double across) const {
    const double reach = side_ * across;
    return period_.y > 0 ? reach - period_.y * std::floor((reach - low_) / period_.y + end_share) : reach;
  }

  /// Whole periods to add to the images so that each begins where the one before ends, when the loop starts at `start`.
  std::vector<Vec2> shifts_from(std::size_t start) const {
    std::vector<Vec2> shifts(round_.size());
    for (std::size_t k = 1; k < round_.size(); ++k) {
      const std::size_t i = (start + k) % round_.size(), before = (start + k - 1) % round_.size();
      const Vec2 gap = round_[before].points.back() + shifts[before] - round_[i].points.front();
      shifts[i] = whole_periods(gap, period_);
    }
    return shifts;
  }

  static long moved(const std::vector<Vec2>& shifts) {
    return std::count_if(shifts.begin(), shifts.end(), [](const Vec2& shift) { return !(shift == Vec2{}); });
  }

  /// The edge that the periodic edge starts before: fewest images to be moved, nothing in the way.
  std::optional<std::size_t> find_start() const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < round_.size(); ++i) {
      const long count = moved(shifts_from(i));
      if ((count > 0 && !may_leave_range()) || (best && count >= moved(shifts_from(*best)))) continue;
      if (is_free(round_[i].points.front())) best = i;
    }
    return best;
  }

  /// Whether images may leave the range of the surface.
  bool may_leave_range() const { return is_round_u_ ? geometry()->IsUPeriodic() : geometry()->IsVPeriodic(); }

  bool is_free(Vec2 from) const {
    auto is_met = [&](const std::vector<Vec2>& line) { return meets(line, from); };
    return std::none_of(round_.begin(), round_.end(), [&](const Walk& walk) { return is_met(walk.points); }) &&
           std::none_of(holes_.begin(), holes_.end(), is_met);
  }

  /// Whether a line meets the way from `from` across to the pole, in any period.
  bool meets(const std::vector<Vec2>& line, Vec2 from) const {
    const double start = reach_of(from.y), slack = end_share * (pole_ - start);
    auto is_between = [&](double across) {
      const double reach = reach_of(across);
      return reach > start + slack && reach < pole_ - slack;
    };
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Vec2 a = line[k - 1], b = line[k];
      const double low = std::min(a.x, b.x), high = std::max(a.x, b.x);
      const double x = from.x + period_.x * std::ceil((low - from.x) / period_.x - end_share);
      if (x > high + end_share * period_.x) continue;
      const double width = b.x - a.x;
      if (std::abs(width) <= end_share * period_.x ? is_between(a.y) || is_between(b.y)
                                                   : is_between(a.y + (b.y - a.y) * (x - a.x) / width))
        return true;
    }
    return false;
  }

  Handle(Geom_Surface) geometry() const {
    TopLoc_Location location;
    return untrimmed(BRep_Tool::Surface(face_, location));
  }

  /// Whole periods across that bring the face into the range of a surface that is closed across and no more; nothing
  /// where it goes over the line on which that surface closes.
  std::optional<double> shift_across() const {
    if (period_.y == 0 || (is_round_u_ ? geometry()->IsVPeriodic() : geometry()->IsUPeriodic())) return 0;
    std::array<double, 4> bounds{};
    geometry()->Bounds(bounds[0], bounds[1], bounds[2], bounds[3]);
    const double start = bounds[is_round_u_ ? 2 : 0], slack = end_share * period_.y;
    const double low = side_ * (side_ > 0 ? low_ : pole_), high = side_ * (side_ > 0 ? pole_ : low_);
    const double shift = period_.y * std::ceil((start - slack - low) / period_.y);
    if (high + shift > start + period_.y + slack) return std::nullopt;
    return shift;
  }

  CompletedFace build(std::size_t start, double across) const {
    std::vector<Vec2> shifts = shifts_from(start);
    for (Vec2& shift : shifts) shift = shift + Vec2{0, across};
    const Vec2 first = round_[start].points.front(), from{first.x, first.y + across},
               to{from.x, from.y + side_ * (pole_ - reach_of(first.y))};
    const Vec2 turn{turn_ * period_.x, 0};
    const TopoDS_Vertex bottom = round_[start].from, top = top_vertex(to);
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.UpdateVertex(bottom, BRep_Tool::Pnt(bottom).Distance(to_point(at(from.x, from.y))));
    builder.MakeWire(wire);
    for (std::size_t k = 0; k < round_.size(); ++k) {
      const std::size_t i = (start + k) % round_.size();
      if (!(shifts[i] == Vec2{})) move_image(round_[i].edge, turned(shifts[i]));
      builder.Add(wire, round_[i].edge);
    }
    const bool is_up = to.y > from.y;
    const TopoDS_Edge side = make_side(from, to, turn, is_up ? bottom : top, is_up ? top : bottom);
    builder.Add(wire, side.Oriented(is_up ? TopAbs_FORWARD : TopAbs_REVERSED));
    builder.Add(wire, make_pole(to + turn, to, top));
    builder.Add(wire, side.Oriented(is_up ? TopAbs_REVERSED : TopAbs_FORWARD));
    wire.Closed(Standard_True);
    CompletedFace made{face_with(face_, wire, wire_), side, {}};
    for (const Walk& walk : periodic_) made.replaced.push_back(walk.edge);
    return made;
  }

  /// The pole as a loop of its own.
  CompletedFace with_pole_alone() const {
    const Vec2 from{round_.front().points.front().x, side_ * pole_}, turn{turn_ * period_.x, 0};
    TopoDS_Wire wire;
    BRep_Builder builder;
    builder.MakeWire(wire);
    builder.Add(wire, make_pole(from + turn, from, top_vertex(from)));
    wire.Closed(Standard_True);
    return {face_with(face_, wire, {}), {}, {}};
  }

  /// The vertex that a periodic edge of the file leads to, else a new one.
  TopoDS_Vertex top_vertex(Vec2 to) const {
    const gp_Pnt point = to_point(at(to.x, to.y));
    for (const Walk& walk : periodic_)
      for (const TopoDS_Vertex& vertex : {walk.from, walk.to})
        if (BRep_Tool::Pnt(vertex).Distance(point) <= std::max(tolerance_, BRep_Tool::Tolerance(vertex))) return vertex;
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, point, std::max(Precision::Confusion(), extent(pole_)));
    return vertex;
  }

  void move_image(const TopoDS_Edge& edge, Vec2 shift) const {
    const EdgeImage image = image_of(edge, face_);
    const Handle(Geom2d_Curve) moved = Handle(Geom2d_Curve)::DownCast(image.curve->Copy());
    moved->Translate(gp_Vec2d(shift.x, shift.y));
    BRep_Builder().UpdateEdge(edge, moved, face_, BRep_Tool::Tolerance(edge));
    BRep_Builder().Range(edge, face_, image.first, image.last);
  }

  Handle(Geom2d_Line) line(Vec2 point, Vec2 direction) const {
    const Vec2 uv = turned(point), along = turned(direction);
    return new Geom2d_Line(gp_Pnt2d(uv.x, uv.y), gp_Dir2d(along.x, along.y));
  }

  /// The periodic edge, in the direction in which the parameter across grows.
  TopoDS_Edge make_side(Vec2 from, Vec2 to, Vec2 turn, const TopoDS_Vertex& low, const TopoDS_Vertex& high) const {
    TopLoc_Location location;
    BRep_Tool::Surface(face_, location);
    const Handle(Geom_Surface) surface = geometry();
    double tolerance = Precision::Confusion();
    for (int i = 0; i <= edge_samples; ++i) {
      const double across = from.y + (to.y - from.y) * i / edge_samples;
      tolerance = std::max(tolerance, norm(at(from.x, across) - at(from.x + turn.x, across)));
    }
    TopoDS_Edge side;
    BRep_Builder builder;
    builder.MakeEdge(side, is_round_u_ ? surface->UIso(from.x) : surface->VIso(from.x), location, tolerance);
    const Handle(Geom2d_Line) there = line({from.x + turn.x, 0}, {0, 1}), back = line({from.x, 0}, {0, 1});
    const bool is_up = to.y > from.y;
    builder.UpdateEdge(side, is_up ? there : back, is_up ? back : there, face_, tolerance);
    builder.Add(side, low.Oriented(TopAbs_FORWARD));
    builder.Add(side, high.Oriented(TopAbs_REVERSED));
    builder.Range(side, std::min(from.y, to.y), std::max(from.y, to.y));
    return side;
  }

  TopoDS_Edge make_pole(Vec2 from, Vec2 to, const TopoDS_Vertex& vertex) const {
    TopoDS_Edge pole;
    BRep_Builder builder;
    builder.MakeEdge(pole);
    builder.UpdateEdge(pole, line(from, to - from), face_, BRep_Tool::Tolerance(vertex));
    builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
    builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
    builder.Range(pole, 0, norm(to - from));
    builder.Degenerated(pole, Standard_True);
    return pole;
  }

  const TopoDS_Face& face_;
  double tolerance_;
  std::unique_ptr<Surface> surface_;
  bool is_round_u_ = true;  ///< which parameter goes round; the other one goes across
  Vec2 period_;             ///< round and across
  int turn_ = 0;            ///< 1: the loop goes with the parameter round, -1: against it
  int side_ = 0;            ///< 1: the face lies where the parameter across grows. Reach is that parameter times side
  Walks round_, periodic_;
  TopoDS_Shape wire_;
  std::vector<std::vector<Vec2>> holes_;
  double low_ = 0, high_ = 0;  ///< reach of the loop
  double pole_ = 0;            ///< reach
};

}  // namespace

TopoDS_Edge edge_without_end(const TopoDS_Face& face) {
  try {
    PoleCompleter completer(face, 0);
    return completer.find_loop() ? completer.first_edge() : TopoDS_Edge();
  } catch (const Error&) {
    return {};  // its surface has no value somewhere
  }
}

std::optional<CompletedFace> completed_to_pole(const TopoDS_Face& face, double diagonal) {
  try {
    PoleCompleter completer(face, diagonal);
    if (!completer.find_loop()) return std::nullopt;
    return completer.complete();
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace paver
