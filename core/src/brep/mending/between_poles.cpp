// Ogives that files give as a whole spindle: a surface of revolution whose closed meridian crosses the axis twice has a
// core between these poles and a shell around it. A STEP face that ends at poles only has a vertex for its border, not
// a parameter, and is read as all of the surface, which runs through itself there. Meant is one piece: programs let a
// meridian's parameters start where the curve that was turned starts, and run along it.
// 1. All edges are periodic ones.
// 2. Where the meridian crosses the axis, by signed distances.
// 3. The piece from the start of the parameters where that is a pole; else the one that does not go over the start.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <algorithm>
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
constexpr double flat_share = 1e-9;   // of the meridian's size
constexpr double start_share = 1e-6;  // of the period: a pole there is the start

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

  /// Whether it lies in one plane with the axis.
  bool is_planar() const {
    for (int i = 0; i < samples; ++i)
      if (const gp_Vec from = from_axis(at(i)); (from - from.Dot(side_) * side_).Magnitude() > flat_share * size_)
        return false;
    return size_ > 0;
  }

  /// Parameters where it is on the axis, rising.
  std::vector<double> crossings() const {
    std::vector<double> found;
    for (int i = 0; i < samples; ++i) {
      double low = at(i), high = at(i + 1);
      const bool is_beyond = distance(low) > 0;
      if (is_beyond == (distance(high) > 0)) continue;
      for (int k = 0; k < bisections; ++k) {
        const double middle = 0.5 * (low + high);
        ((distance(middle) > 0) == is_beyond ? low : high) = middle;
      }
      found.push_back(0.5 * (low + high));
    }
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

  Handle(Geom_Curve) curve_;
  gp_Ax1 axis_;
  double size_ = 0;  // its largest distance from the axis,
  gp_Vec side_;      // and where it has that
};

// A pole at the start of the parameters is their end, too.
bool has_periodic_edges_only(const TopoDS_Face& face) {
  return std::ranges::all_of(edges_of(face), [&](const TopoDS_Edge& edge) { return BRep_Tool::IsClosed(edge, face); });
}

}  // namespace

std::optional<TopoDS_Face> between_poles(const TopoDS_Face& face) {
  TopLoc_Location location;
  const auto surface = Handle(Geom_SurfaceOfRevolution)::DownCast(untrimmed(BRep_Tool::Surface(face, location)));
  if (surface.IsNull() || !surface->IsVPeriodic() || !has_periodic_edges_only(face)) return std::nullopt;
  const Meridian meridian(*surface);
  if (!meridian.is_planar()) return std::nullopt;
  std::vector<double> poles = meridian.crossings();
  if (poles.size() != 2) return std::nullopt;
  if (poles[0] < meridian.first() + start_share * meridian.period()) poles[0] = meridian.first();
  BRepBuilderAPI_MakeFace maker(surface, 0, 2 * std::numbers::pi, poles[0], poles[1], Precision::Confusion());
  if (!maker.IsDone()) return std::nullopt;
  return TopoDS::Face(TopoDS::Face(maker.Shape()).Moved(location));
}

}  // namespace paver
