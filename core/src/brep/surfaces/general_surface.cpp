// Surfaces without a closed form: B-spline and Bezier surfaces evaluated here, others by OpenCASCADE's adaptor.
// Parameters outside a closed direction are wrapped; beyond the ends of a bounded one the surface is continued
// linearly, because a polynomial of high degree explodes there and a Newton step may well look.
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"
#include "brep/surfaces/spline_surface.h"

namespace paver {
namespace {

constexpr int closure_samples = 16;
/// Gap between the ends, over the width of the surface, that still counts as closed.
constexpr double closure_share = 1e-6;
/// Part of the range by which a parameter without a value is moved towards the middle.
constexpr double singular_step = 1e-7;

/// Part of the range by which a polynomial may be used beyond its ends: images of edges overshoot by rounding.
constexpr double end_slack = 1e-4;

struct Range {
  double first = 0, last = 0;
  bool is_bounded = false;  ///< both ends finite
  double period = 0;        ///< 0: open

  double wrapped(double t) const {
    if (period <= 0 || (t >= first && t <= first + period)) return t;
    double r = t - period * std::floor((t - first) / period);
    return std::clamp(r, first, first + period);
  }
  double clamped(double t) const {
    double slack = end_slack * (last - first);
    return is_bounded && period <= 0 ? std::clamp(t, first - slack, last + slack) : t;
  }
};

bool is_finite(Vec3 a) { return std::isfinite(a.x + a.y + a.z); }

template <class Source>
void copy_poles(const Source& source, const gp_Trsf& placement, SplineNet& net) {
  net.is_rational = source.IsURational() || source.IsVRational();
  net.poles.reserve(static_cast<std::size_t>(source.NbUPoles()) * source.NbVPoles());
  for (int i = 1; i <= source.NbUPoles(); ++i)
    for (int j = 1; j <= source.NbVPoles(); ++j) {
      gp_Pnt p = source.Pole(i, j).Transformed(placement);
      double w = net.is_rational ? source.Weight(i, j) : 1;
      net.poles.push_back(Pole{Pole::Pair{w * p.X(), w * p.Y()}, Pole::Pair{w * p.Z(), net.is_rational ? w : 0}});
    }
}

/// Null for surfaces of other kinds.
std::shared_ptr<const SplineNet> make_spline_net(const Handle(Geom_Surface) & surface, const gp_Trsf& placement) {
  auto net = std::make_shared<SplineNet>();
  if (auto bezier = Handle(Geom_BezierSurface)::DownCast(surface)) {
    auto basis = [](int degree) {
      std::vector<double> knots(degree + 1, 0.0);
      knots.resize(2 * degree + 2, 1.0);
      return SplineBasis(degree, knots);
    };
    net->u = basis(bezier->UDegree()), net->v = basis(bezier->VDegree());
    copy_poles(*bezier, placement, *net);
    return net;
  }
  auto spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (spline.IsNull()) return nullptr;
  if (spline->IsUPeriodic() || spline->IsVPeriodic()) {
    spline = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
    if (spline->IsUPeriodic()) spline->SetUNotPeriodic();
    if (spline->IsVPeriodic()) spline->SetVNotPeriodic();
  }
  auto flat = [](const TColStd_Array1OfReal& knots) { return std::vector<double>(knots.begin(), knots.end()); };
  net->u = {spline->UDegree(), flat(spline->UKnotSequence())};
  net->v = {spline->VDegree(), flat(spline->VKnotSequence())};
  copy_poles(*spline, placement, *net);
  return net;
}

class GeneralSurface : public Surface {
 public:
  GeneralSurface(const Handle(Geom_Surface) & surface, const gp_Trsf& placement, double closure_tolerance)
      : surface_(surface), placement_(placement), is_placed_(placement.Form() != gp_Identity), adaptor_(surface) {
    if (auto net = make_spline_net(surface, placement)) spline_.emplace(net);
    surface->Bounds(u_.first, u_.last, v_.first, v_.last);
    auto is_bounded = [](const Range& r) { return !Precision::IsInfinite(r.first) && !Precision::IsInfinite(r.last); };
    u_.is_bounded = is_bounded(u_);
    v_.is_bounded = is_bounded(v_);
    double scale = std::abs(placement.ScaleFactor());
    u_.period = surface->IsUPeriodic() ? surface->UPeriod() : closed_width(true, closure_tolerance / scale);
    v_.period = surface->IsVPeriodic() ? surface->VPeriod() : closed_width(false, closure_tolerance / scale);
  }
  GeneralSurface(const GeneralSurface& other)
      : Surface(other),
        surface_(other.surface_),
        placement_(other.placement_),
        is_placed_(other.is_placed_),
        u_(other.u_),
        v_(other.v_),
        spline_(other.spline_),
        adaptor_(other.surface_) {}
  GeneralSurface& operator=(const GeneralSurface&) = delete;

  Vec3 point(Vec2 uv) const override { return extended(uv, 0).x; }
  SurfaceSlope slope(Vec2 uv) const override { return extended(uv, 1); }
  SurfaceJet jet(Vec2 uv) const override { return extended(uv, 2); }
  SurfaceKind kind() const override { return SurfaceKind::other; }
  Vec2 period() const override { return {u_.period, v_.period}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<GeneralSurface>(*this); }

 private:
  /// Width of the range when the ends of the surface coincide, else 0.
  double closed_width(bool in_u, double tolerance) const {
    const Range& along = in_u ? u_ : v_;
    const Range& across = in_u ? v_ : u_;
    if (!along.is_bounded) return 0;
    double a0 = across.is_bounded ? across.first : 0, a1 = across.is_bounded ? across.last : 1;
    auto at = [&](double s, double a) { return in_u ? surface_->Value(s, a) : surface_->Value(a, s); };
    double gap = 0, width = 0;
    try {
      for (int i = 0; i <= closure_samples; ++i) {
        double a = a0 + (a1 - a0) * i / closure_samples;
        gp_Pnt start = at(along.first, a);
        gap = std::max(gap, start.Distance(at(along.last, a)));
        for (double share : {0.25, 0.5, 0.75})
          width = std::max(width, start.Distance(at(along.first + share * (along.last - along.first), a)));
      }
    } catch (const Standard_Failure&) {
      return 0;  // offset surfaces may have no value at an end: then they are not closed there either
    }
    return gap <= std::max(closure_share * width, std::min(tolerance, 0.01 * width)) && width > 0
               ? along.last - along.first
               : 0;
  }

  SurfaceJet extended(Vec2 uv, int order) const {
    SurfaceJet jet;
    extend(evaluate(uv, order, jet), jet);
    return jet;
  }

  /// Values at the nearest parameters within the bounds; the result is the step from there to `uv`.
  /// With a step the derivatives that continue the surface are evaluated too.
  Vec2 evaluate(Vec2 uv, int order, SurfaceJet& jet) const {
    Vec2 wrapped{u_.wrapped(uv.x), v_.wrapped(uv.y)};
    Vec2 inside{u_.clamped(wrapped.x), v_.clamped(wrapped.y)};
    Vec2 step = wrapped - inside;
    if (!(step == Vec2{})) order = 2;
    if (!try_evaluate(inside, order, jet) && !try_evaluate(moved_inwards(inside), order, jet))
      throw Error(ErrorCode::face_failed, "The surface has no value at u = " + std::to_string(uv.x) + ", v = " +
                                              std::to_string(uv.y) + "; repair the face in the CAD program.");
    return step;
  }

  bool try_evaluate(Vec2 uv, int order, SurfaceJet& jet) const {
    if (spline_)
      spline_->evaluate(uv.x, uv.y, order, jet);
    else if (!adapt(uv, order, jet))
      return false;
    return is_finite(jet.x) && is_finite(jet.u + jet.v) && is_finite(jet.uu + jet.vv + jet.uv);
  }

  bool adapt(Vec2 uv, int order, SurfaceJet& jet) const {
    gp_Pnt x;
    gp_Vec u, v, uu, uv_, vv;
    try {
      if (order == 0) {
        adaptor_.D0(uv.x, uv.y, x);
      } else if (order == 1) {
        adaptor_.D1(uv.x, uv.y, x, u, v);
      } else {
        adaptor_.D2(uv.x, uv.y, x, u, v, uu, vv, uv_);
      }
    } catch (const Standard_Failure&) {
      return false;
    }
    if (is_placed_) {
      x.Transform(placement_);
      for (gp_Vec* a : {&u, &v, &uu, &uv_, &vv}) a->Transform(placement_);
    }
    jet = {{to_vec(x), to_vec(u), to_vec(v)}, to_vec(uu), to_vec(uv_), to_vec(vv)};
    return true;
  }

  Vec2 moved_inwards(Vec2 uv) const {
    auto moved = [](const Range& r, double t) {
      if (!r.is_bounded) return t + singular_step;
      return t + singular_step * (t > 0.5 * (r.first + r.last) ? r.first - r.last : r.last - r.first);
    };
    return {moved(u_, uv.x), moved(v_, uv.y)};
  }

  /// Bilinear continuation over `step`: the derivatives belong exactly to the continued point, save the second ones
  /// along the border, which would need third derivatives.
  static void extend(Vec2 step, SurfaceJet& jet) {
    if (step == Vec2{}) return;
    jet.x += step.x * jet.u + step.y * jet.v + step.x * step.y * jet.uv;
    jet.u += step.y * jet.uv;
    jet.v += step.x * jet.uv;
    if (step.x != 0) jet.uu = {};
    if (step.y != 0) jet.vv = {};
  }

  Handle(Geom_Surface) surface_;
  gp_Trsf placement_;
  bool is_placed_;
  Range u_, v_;
  std::optional<SplineSurface> spline_;
  GeomAdaptor_Surface adaptor_;
};

}  // namespace

std::unique_ptr<Surface> make_surface(const TopoDS_Face& face, double closure_tolerance) {
  TopLoc_Location location;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  if (surface.IsNull()) return nullptr;
  surface = untrimmed(surface);
  gp_Trsf placement = location.Transformation();
  if (auto elementary = make_elementary_surface(surface, placement)) return elementary;
  return std::make_unique<GeneralSurface>(surface, placement, closure_tolerance);
}

}  // namespace paver
