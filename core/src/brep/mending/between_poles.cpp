// Ogives that files give as a whole spindle: a surface of revolution whose closed meridian crosses the axis twice has a
// core between these poles and a shell around it. A STEP face that ends at poles only has a vertex for its border, not
// a parameter, and is read as all of the surface, which runs through itself there. Meant is one piece: programs let a
// meridian's parameters start where the curve that was turned starts, and run along it.
// Besides, tori whose hole is a point: there the meridian comes to the axis and turns back, within the face.
// 1. All edges are periodic ones.
// 2. Where the meridian crosses the axis or touches it, by signed distances and their slopes.
// 3. All of it from a touch on; else the piece from the start of the parameters where that is a pole; else the one that
//    does not go over the start.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_Conic.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

constexpr int samples = 90;
constexpr int bisections = 50;
constexpr double flat_share = 1e-9;    // of the meridian's size
constexpr double start_share = 1e-6;   // of the period: a pole there is the start
constexpr double most_rounded = 3e-5;  // of the meridian's size: about 1e-5 of the diagonal, as between parts

/// How far a meridian is from the axis, negative on the other side of it.
class Meridian {
 public:
  explicit Meridian(const Geom_SurfaceOfRevolution& surface) : curve_(surface.BasisCurve()), axis_(surface.Axis()) {
    for (int i = 0; i < samples; ++i) {
      const gp_Vec from = from_axis(at(i));
      if (from.Magnitude() > size_) size_ = from.Magnitude(), side_ = from / size_;
    }
  }

  double first() const { return curve_->FirstParameter(); }
  double period() const { return curve_->Period(); }

  /// How far it is at most from the plane that the axis and its farthest place lie in, per its size.
  double off_plane() const {
    double most = 0;
    for (int i = 0; i < samples; ++i) {
      const gp_Vec from = from_axis(at(i));
      most = std::max(most, (from - from.Dot(side_) * side_).Magnitude());
    }
    return size_ > 0 ? most / size_ : INFINITY;
  }

  /// Where it comes to the axis and turns back.
  std::optional<double> touch() const {
    for (int i = 0; i < samples; ++i)
      if (const auto turn = root(i, [&](double t) { return slope(t); }))
        if (std::abs(distance(*turn)) <= flat_share * size_) return turn;
    return std::nullopt;
  }

  /// Parameters where it is on the axis, rising.
  std::vector<double> crossings() const {
    std::vector<double> found;
    for (int i = 0; i < samples; ++i)
      if (const auto crossing = root(i, [&](double t) { return distance(t); })) found.push_back(*crossing);
    return found;
  }

 private:
  /// Half a sample behind the start, which may be on the axis.
  double at(int sample) const { return first() + period() * (sample - 0.5) / samples; }
  gp_Vec from_axis(double t) const {
    const gp_Vec from(axis_.Location(), curve_->Value(t)), along(axis_.Direction());
    return from - from.Dot(along) * along;
  }
  double distance(double t) const { return from_axis(t).Dot(side_); }
  double slope(double t) const { return curve_->DN(t, 1).Dot(side_); }

  /// Where f changes its sign between a sample and the next.
  template <class F>
  std::optional<double> root(int sample, F f) const {
    double low = at(sample), high = at(sample + 1);
    const bool is_above = f(low) > 0;
    if (is_above == (f(high) > 0)) return std::nullopt;
    for (int k = 0; k < bisections; ++k) {
      const double middle = 0.5 * (low + high);
      ((f(middle) > 0) == is_above ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  Handle(Geom_Curve) curve_;
  gp_Ax1 axis_;
  double size_ = 0;  // its largest distance from the axis,
  gp_Vec side_;      // and where it has that
};

// A pole at the start of the parameters is their end, too.
bool has_periodic_edges_only(const TopoDS_Face& face) {
  return std::ranges::all_of(edges_of(face), [&](const TopoDS_Edge& edge) { return BRep_Tool::IsClosed(edge, face); });
}

/// A conic that is turned about an axis beside its plane, as rounded numbers leave it: the axis in its plane.
Handle(Geom_SurfaceOfRevolution) with_axis_in_plane(const Geom_SurfaceOfRevolution& surface, const Geom_Conic& conic) {
  const gp_Ax1 axis = surface.Axis();
  const gp_Vec along(axis.Direction()), normal(conic.Axis().Direction());
  const gp_Dir across(normal - normal.Dot(along) * along);
  const double above = gp_Vec(axis.Location(), conic.Location()).Dot(gp_Vec(across));
  const auto moved = Handle(Geom_Conic)::DownCast(conic.Copy());
  moved->SetAxis(gp_Ax1(conic.Location().Translated(-above * gp_Vec(across)), across));
  return new Geom_SurfaceOfRevolution(moved, axis);
}

/// Along the meridian, of the piece that is meant; the surface may be made anew.
std::optional<std::array<double, 2>> poles_of(Handle(Geom_Surface) & surface) {
  if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull()) {
    const double hole = torus->MajorRadius() - torus->MinorRadius();
    if (std::abs(hole) > flat_share * torus->MajorRadius()) return std::nullopt;
    return std::array{std::numbers::pi, 3 * std::numbers::pi};
  }
  auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(surface);
  if (revolved.IsNull()) return std::nullopt;
  const double off = Meridian(*revolved).off_plane();
  const auto conic = Handle(Geom_Conic)::DownCast(untrimmed(revolved->BasisCurve()));
  if (off > (conic.IsNull() ? flat_share : most_rounded)) return std::nullopt;
  if (off > flat_share) surface = revolved = with_axis_in_plane(*revolved, *conic);
  const Meridian meridian(*revolved);
  if (const std::optional<double> touch = meridian.touch()) return std::array{*touch, *touch + meridian.period()};
  std::vector<double> poles = meridian.crossings();
  if (poles.size() != 2) return std::nullopt;
  if (poles[0] < meridian.first() + start_share * meridian.period()) poles[0] = meridian.first();
  return std::array{poles[0], poles[1]};
}

}  // namespace

std::optional<TopoDS_Face> between_poles(const TopoDS_Face& face) {
  TopLoc_Location location;
  Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face, location));
  if (surface.IsNull() || !surface->IsVPeriodic() || !has_periodic_edges_only(face)) return std::nullopt;
  const std::optional<std::array<double, 2>> poles = poles_of(surface);
  if (!poles) return std::nullopt;
  BRepBuilderAPI_MakeFace maker(surface, 0, 2 * std::numbers::pi, (*poles)[0], (*poles)[1], Precision::Confusion());
  if (!maker.IsDone()) return std::nullopt;
  return TopoDS::Face(TopoDS::Face(maker.Shape()).Moved(location));
}

}  // namespace paver
