// Curves of edges, in space and in the (u, v) of faces. They ask the geometry itself, never an adaptor: geometry has no
// cache, so any number of threads may evaluate one object.
#include <BRep_Tool.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopLoc_Location.hxx>
#include <algorithm>
#include <gp_Pnt2d.hxx>
#include <gp_Vec2d.hxx>
#include <limits>

#include "base/segment.h"
#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

[[noreturn]] void throw_no_value(double t, const Standard_Failure& failure) {
  throw Error(ErrorCode::face_failed, "An edge's curve has no value at t = " + std::to_string(t) + " (" +
                                          failure_text(failure) + "); repair the edge in the CAD program.");
}

class SpaceCurve : public Curve {
 public:
  SpaceCurve(Handle(Geom_Curve) curve, const gp_Trsf& placement)
      : curve_(std::move(curve)), placement_(placement), is_placed_(placement.Form() != gp_Identity) {}

  Vec3 point(double t) const override {
    gp_Pnt x;
    call(t, [&] { curve_->D0(t, x); });
    return placed(x);
  }
  CurveSlope slope(double t) const override {
    gp_Pnt p;
    gp_Vec d;
    call(t, [&] { curve_->D1(t, p, d); });
    return {placed(p), placed(d)};
  }
  CurveJet jet(double t) const override {
    gp_Pnt p;
    gp_Vec d, dd;
    call(t, [&] { curve_->D2(t, p, d, dd); });
    return {{placed(p), placed(d)}, placed(dd)};
  }

 private:
  template <class F>
  static void call(double t, F&& f) {
    try {
      f();
    } catch (const Standard_Failure& failure) {
      throw_no_value(t, failure);
    }
  }

  /// Of a point or vector.
  template <class A>
  Vec3 placed(A a) const {
    if (is_placed_) a.Transform(placement_);
    return to_vec(a);
  }

  Handle(Geom_Curve) curve_;
  gp_Trsf placement_;
  bool is_placed_;
};

/// An edge known only by its image on a surface.
class CurveOnSurface : public Curve {
 public:
  CurveOnSurface(Handle(Geom2d_Curve) curve, Handle(Geom_Surface) surface, const gp_Trsf& placement)
      : curve_(std::move(curve)), surface_(std::move(surface)), placement_(placement) {}

  Vec3 point(double t) const override { return evaluate(t, 0).x; }
  CurveSlope slope(double t) const override { return evaluate(t, 1); }
  CurveJet jet(double t) const override { return evaluate(t, 2); }

 private:
  CurveJet evaluate(double t, int order) const {
    gp_Pnt2d uv;
    gp_Vec2d d, dd;
    gp_Pnt p;
    gp_Vec u, v, uu, vv, w;
    try {
      curve_->D2(t, uv, d, dd);
      if (order == 0) {
        surface_->D0(uv.X(), uv.Y(), p);
      } else if (order == 1) {
        surface_->D1(uv.X(), uv.Y(), p, u, v);
      } else {
        surface_->D2(uv.X(), uv.Y(), p, u, v, uu, vv, w);
      }
    } catch (const Standard_Failure& failure) {
      throw_no_value(t, failure);
    }
    gp_Vec first = d.X() * u + d.Y() * v;
    gp_Vec second = d.X() * d.X() * uu + 2 * d.X() * d.Y() * w + d.Y() * d.Y() * vv + dd.X() * u + dd.Y() * v;
    return {{to_vec(p.Transformed(placement_)), to_vec(first.Transformed(placement_))},
            to_vec(second.Transformed(placement_))};
  }

  Handle(Geom2d_Curve) curve_;
  Handle(Geom_Surface) surface_;
  gp_Trsf placement_;
};

}  // namespace

std::shared_ptr<const Curve> make_curve(const TopoDS_Edge& edge) {
  TopLoc_Location location;
  double first = 0, last = 0;
  Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
  if (!curve.IsNull()) {
    while (auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
    return std::make_shared<SpaceCurve>(curve, location.Transformation());
  }
  Handle(Geom2d_Curve) image;
  Handle(Geom_Surface) surface;
  BRep_Tool::CurveOnSurface(edge, image, surface, location, first, last);
  if (image.IsNull() || surface.IsNull()) return nullptr;
  return std::make_shared<CurveOnSurface>(image, surface, location.Transformation());
}

SampledCurve sampled(std::shared_ptr<const Curve> curve, double t0, double t1, int pieces) {
  SampledCurve line{std::move(curve), {}, {}};
  for (int i = 0; i <= pieces; ++i) {
    line.t.push_back(t0 + (t1 - t0) * i / pieces);
    line.points.push_back(line.curve->point(line.t.back()));
  }
  return line;
}

double length_of(const SampledCurve& line) {
  double length = 0;
  for (std::size_t k = 1; k < line.points.size(); ++k) length += norm(line.points[k] - line.points[k - 1]);
  return length;
}

double distance_near(const SampledCurve& line, std::size_t k, double t, int steps, Vec3 x) {
  const double from = line.t[std::max<std::size_t>(k, 2) - 2], to = line.t[std::min(k + 1, line.t.size() - 1)];
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const auto [y, yt] = line.curve->slope(t);
    least = std::min(least, norm(x - y));
    if (!(dot(yt, yt) > 0)) break;
    t = std::clamp(t + dot(x - y, yt) / dot(yt, yt), std::min(from, to), std::max(from, to));
  }
  return least;
}

double distance_to(const SampledCurve& line, int steps, Vec3 x) {
  std::size_t nearest = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < line.points.size(); ++k)
    if (const double off = distance_to_segment(x, line.points[k - 1], line.points[k]); off < least)
      least = off, nearest = k;
  return distance_near(line, nearest, 0.5 * (line.t[nearest - 1] + line.t[nearest]), steps, x);
}

std::shared_ptr<const ParameterCurve> make_parameter_curve(const TopoDS_Edge& edge, const TopoDS_Face& face, double t0,
                                                           double t1) {
  double first = 0, last = 0;
  Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return nullptr;
  while (auto trimmed = Handle(Geom2d_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
  // The range of the image should be the edge's; where it is not, map one onto the other.
  constexpr double same_range = 1e-12;
  double width = t1 - t0;
  bool is_same = std::abs(first - t0) <= same_range * width && std::abs(last - t1) <= same_range * width;
  double scale = is_same || width <= 0 ? 1 : (last - first) / width;
  double shift = is_same ? 0 : first - scale * t0;
  return image_by([curve, scale, shift](double t) -> Vec2 {
    gp_Pnt2d p;
    try {
      curve->D0(scale * t + shift, p);
    } catch (const Standard_Failure& failure) {
      throw_no_value(t, failure);
    }
    return {p.X(), p.Y()};
  });
}

std::shared_ptr<const ParameterCurve> make_straight_parameter_curve(Vec2 a, Vec2 b, double t0, double t1) {
  return image_by([=](double t) {
    const double s = t1 > t0 ? (t - t0) / (t1 - t0) : 0;
    return (1 - s) * a + s * b;
  });
}

}  // namespace paver
