// A false pole that runs out and back along itself, as the end of a body pressed flat does, becomes an edge that the
// face uses twice, so that the body is closed there. Steps: its turning points, which are farthest from each other;
// which of its points are the same; an edge from turning point to turning point, or two where the pole starts in
// between.
#include <BRep_Builder.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "brep/mending/mend_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

constexpr int samples = 96;       // in which turning points are sought
constexpr int most_steps = 60;    // of a search in an interval
constexpr int checks = 32;        // points whose twins must be there
constexpr double snap = 1e-6;     // of the range: so near to a sample a turning point is one
constexpr double flat = 1e-6;     // of the diagonal: how far its two halves may be apart, or as far as its tolerance
constexpr double thin = 1e-3;     // of its length: but never farther
constexpr double exactly = 1e-9;  // of the range: a way back as even as the way there

class Border {
 public:
  Border(const TopoDS_Face& face, const TopoDS_Edge& pole, double tolerance) : face_(face), tolerance_(tolerance) {
    const EdgeImage image = image_of(forward(pole), face);
    const auto line = Handle(Geom2d_Line)::DownCast(image.curve);
    if (line.IsNull()) return;
    const gp_Dir2d way = line->Direction();
    is_along_v_ = std::fabs(way.X()) < Precision::Angular();
    if (!is_along_v_ && std::fabs(way.Y()) >= Precision::Angular()) return;
    const gp_Pnt2d from = line->Value(image.first), to = line->Value(image.last);
    fixed_ = is_along_v_ ? from.X() : from.Y();
    low_ = is_along_v_ ? from.Y() : from.X(), high_ = is_along_v_ ? to.Y() : to.X();
    is_falling_ = low_ > high_;
    if (is_falling_) std::swap(low_, high_);
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location_);
    curve_ = is_along_v_ ? surface->UIso(fixed_) : surface->VIso(fixed_);
    start_ = TopExp::FirstVertex(forward(pole));
  }

  /// Whether it runs out and back along itself.
  bool find_turns() {
    if (curve_.IsNull() || start_.IsNull() || at(low_).Distance(at(high_)) > tolerance_) return false;
    double farthest = 0;
    for (int i = 0; i < samples; ++i)
      for (int j = 0; j < i; ++j)
        if (const double d = sample(i).Distance(sample(j)); d > farthest * (1 + snap))
          farthest = d, turn_[0] = parameter(j), turn_[1] = parameter(i);
    tolerance_ = std::min(tolerance_, thin * farthest);
    for (const int k : {0, 1, 0, 1}) turn_[k] = farthest_from(at(turn_[1 - k]), turn_[k]);
    if (turn_[0] > turn_[1]) std::swap(turn_[0], turn_[1]);
    const double room = 2 * (high_ - low_) / samples;
    if (!(turn_[1] - turn_[0] > room && high_ - turn_[1] > room)) return false;
    for (int i = 1; i < checks; ++i) {
      const double w = turn_[0] + (turn_[1] - turn_[0]) * i / checks;
      if (at(w).Distance(at(twin(w))) > tolerance_) return false;
    }
    return true;
  }

  /// With their orientation, in the order in which a wire that has the pole FORWARD runs through them.
  std::vector<TopoDS_Edge> edges() const {
    std::vector<TopoDS_Edge> result;
    auto add = [&](double from, double to, double twin_from, const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
      TopoDS_Edge edge = make_edge(from, to, twin_from);
      BRep_Builder builder;
      builder.Add(edge, a.Oriented(TopAbs_FORWARD));
      builder.Add(edge, b.Oriented(TopAbs_REVERSED));
      for (const auto orientation : {TopAbs_FORWARD, TopAbs_REVERSED})
        result.push_back(TopoDS::Edge(edge.Oriented(orientation)));
    };
    if (turn_[0] - low_ < snap * (high_ - low_)) {
      add(low_, turn_[1], high_, start_, vertex_at(turn_[1]));
    } else {
      const double again = twin(high_);
      add(low_, turn_[0], again, start_, vertex_at(turn_[0]));
      add(again, turn_[1], high_, start_, vertex_at(turn_[1]));
    }
    if (is_falling_) {
      std::reverse(result.begin(), result.end());
      for (TopoDS_Edge& edge : result) edge.Reverse();
    }
    return result;
  }

 private:
  gp_Pnt at(double w) const {
    if (w > high_) w -= high_ - low_;
    if (w < low_) w += high_ - low_;
    return curve_->Value(w);
  }
  double parameter(int i) const { return low_ + (high_ - low_) * i / samples; }
  gp_Pnt sample(int i) const { return at(parameter(i)); }

  double farthest_from(const gp_Pnt& other, double w) const {
    const double step = (high_ - low_) / samples;
    double a = w - step, b = w + step;
    for (int i = 0; i < most_steps; ++i) {
      const double third = (b - a) / 3;
      if (at(a + third).Distance(other) < at(b - third).Distance(other))
        a += third;
      else
        b -= third;
    }
    const double found = 0.5 * (a + b), nearest = low_ + step * std::round((found - low_) / step);
    double result = std::fabs(found - nearest) < snap * (high_ - low_) ? nearest : found;
    if (result >= high_) result -= high_ - low_;
    return result < low_ ? result + (high_ - low_) : result;
  }

  /// The other parameter of the same point, as far from the first turning point; on the other way.
  double twin(double w) const {
    const gp_Pnt from = at(turn_[0]);
    const double reach = at(w).Distance(from);
    const bool is_out = w > turn_[0] && w < turn_[1];
    double a = is_out ? turn_[0] + (high_ - low_) : turn_[0], b = turn_[1];
    for (int i = 0; i < most_steps; ++i) {
      const double middle = 0.5 * (a + b);
      (at(middle).Distance(from) < reach ? a : b) = middle;
    }
    const double found = 0.5 * (a + b);
    return found > high_ ? found - (high_ - low_) : found;
  }

  TopoDS_Vertex vertex_at(double w) const {
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, at(w).Transformed(location_.Transformation()), tolerance_);
    return vertex;
  }

  /// `twin_from`: the twin of `from`.
  TopoDS_Edge make_edge(double from, double to, double twin_from) const {
    TopoDS_Edge edge;
    BRep_Builder builder;
    builder.MakeEdge(edge, curve_, location_, tolerance_);
    builder.Range(edge, from, to);
    Handle(Geom2d_Curve) there = new Geom2d_Line(image(0), is_along_v_ ? gp::DY2d() : gp::DX2d());
    Handle(Geom2d_Curve) back = way_back(from, to, twin_from);
    if (is_falling_) std::swap(there, back);
    builder.UpdateEdge(edge, there, back, face_, tolerance_);
    builder.Range(edge, face_, from, to);
    return edge;
  }

  gp_Pnt2d image(double w) const { return is_along_v_ ? gp_Pnt2d(fixed_, w) : gp_Pnt2d(w, fixed_); }

  Handle(Geom2d_Curve) way_back(double from, double to, double twin_from) const {
    Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, checks + 1);
    Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, checks + 1);
    bool is_even = true;
    for (int i = 0; i <= checks; ++i) {
      const double w = from + (to - from) * i / checks;
      const double back = i == 0 ? twin_from : i == checks ? to : twin(w);
      is_even = is_even && std::fabs(back - twin_from + w - from) <= exactly * (high_ - low_);
      points->SetValue(i + 1, image(back)), parameters->SetValue(i + 1, w);
    }
    if (is_even) return new Geom2d_Line(image(twin_from + from), is_along_v_ ? -gp::DY2d() : -gp::DX2d());
    Geom2dAPI_Interpolate through(points, parameters, Standard_False, Precision::Confusion());
    through.Perform();
    return Handle(Geom2d_Curve)(through.Curve());
  }

  const TopoDS_Face& face_;
  double tolerance_;
  Handle(Geom_Curve) curve_;
  TopLoc_Location location_;
  TopoDS_Vertex start_;
  double fixed_ = 0, low_ = 0, high_ = 0;
  std::array<double, 2> turn_{};
  bool is_along_v_ = false, is_falling_ = false;
};

}  // namespace

std::optional<PressedFlat> pressed_flat(const TopoDS_Face& face, const TopoDS_Edge& pole, double diagonal) {
  Border border(face, pole, std::max(flat * diagonal, BRep_Tool::Tolerance(pole)));
  if (!border.find_turns()) return std::nullopt;
  PressedFlat result{TopoDS::Face(face.EmptyCopied()), border.edges()};
  BRep_Builder builder;
  for (TopoDS_Iterator wires(face); wires.More(); wires.Next()) {
    const TopoDS_Shape plain = wires.Value().Oriented(TopAbs_FORWARD);
    TopoDS_Shape wire = plain.EmptyCopied();
    for (TopoDS_Iterator parts(plain); parts.More(); parts.Next()) {
      if (!parts.Value().IsSame(pole)) {
        builder.Add(wire, parts.Value());
      } else if (parts.Value().Orientation() == TopAbs_REVERSED) {
        for (auto edge = result.edges.rbegin(); edge != result.edges.rend(); ++edge)
          builder.Add(wire, edge->Reversed());
      } else {
        for (const TopoDS_Edge& edge : result.edges) builder.Add(wire, edge);
      }
    }
    wire.Closed(plain.Closed());
    builder.Add(result.face, wire.Oriented(wires.Value().Orientation()));
  }
  return result;
}

}  // namespace paver
