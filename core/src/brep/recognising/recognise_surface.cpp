// What a swept surface or a spline is. Each way proposes a surface; points of the face say whether it is the same.
// 1. Turned lines and circles, extruded lines and circles: parameters stay but for a start.
// 2. Splines that are planes.
// 3. Splines of straight lines between arcs about one axis: cylinders and cones.
#include <BRepTools.hxx>
#include <ElCLib.hxx>
#include <ElSLib.hxx>
#include <GC_MakeCircle.hxx>
#include <GeomLib_IsPlanarSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "brep/occt_shapes_impl.h"
#include "brep/recognising/recognise_impl.h"

namespace paver {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
/// Directions that are one, radians; and distances from an axis that are none, of the other lengths. What rounding in
/// files leaves, and more: points say whether it is enough.
constexpr double same_direction = 1e-6, no_distance = 1e-9;
/// Places per direction where surfaces are compared, and where turns are added up.
constexpr int samples = 7, turn_samples = 16;

struct Range {
  double u0, u1, v0, v1;
};

gp_Pnt2d unchanged(const gp_Pnt2d& uv) { return uv; }

/// Axes with x outward and u turning about `axis`, whatever z is: left-handed where they must be.
gp_Ax3 axes_about(const gp_Pnt& origin, const gp_Dir& z, const gp_Dir& x, const gp_Dir& axis) {
  gp_Ax3 axes(origin, z, x);
  if (axes.YDirection().Dot(axis.Crossed(x)) < 0) axes.YReverse();
  return axes;
}

/// To a point, from its foot on the axis.
gp_Vec from_axis(const gp_Ax1& axis, const gp_Pnt& point) {
  const gp_Vec from(axis.Location(), point), along(axis.Direction());
  return from - from.Dot(along) * along;
}

/// Null where the line turns into a plane or a hyperboloid (the latter by what is compared later).
Handle(Geom_Surface) turned_line(const gp_Lin& line, const gp_Ax1& axis) {
  const gp_Dir about = axis.Direction();
  const double rise = line.Direction().Dot(about);
  if (std::abs(rise) < same_direction) return {};
  const gp_Dir z = rise > 0 ? about : about.Reversed();
  const gp_Vec out = from_axis(axis, line.Location());
  const gp_Vec aside = gp_Vec(line.Direction()) - rise * gp_Vec(about);
  const gp_Pnt origin = line.Location().Translated(-out);
  const double radius = out.Magnitude();
  if (aside.Magnitude() < same_direction) {
    if (radius <= gp::Resolution()) return {};
    return new Geom_CylindricalSurface(axes_about(origin, z, gp_Dir(out), about), radius);
  }
  const bool starts_at_apex = radius <= no_distance * (1 + radius);
  const gp_Dir x(starts_at_apex ? aside : out);
  const double half_angle = std::atan2(aside.Dot(gp_Vec(x)), std::abs(rise));
  if (std::abs(half_angle) < same_direction / 2) return {};
  return new Geom_ConicalSurface(axes_about(origin, z, x, about), half_angle, starts_at_apex ? 0 : radius);
}

std::optional<Elementary> turned_circle(const gp_Circ& circle, const gp_Ax1& axis, const Range& range) {
  gp_Vec out = from_axis(axis, circle.Location());
  const gp_Pnt origin = circle.Location().Translated(-out);
  const double major = out.Magnitude(), minor = circle.Radius(), middle = 0.5 * (range.v0 + range.v1);
  const bool is_sphere = major <= no_distance * minor;
  if (!is_sphere && major <= minor) return std::nullopt;  // it runs through itself
  if (is_sphere) out = from_axis(axis, ElCLib::Value(middle, circle));
  if (out.Magnitude() <= gp::Resolution()) return std::nullopt;
  const gp_Dir x(out);
  const double equator = ElCLib::Parameter(circle, circle.Location().Translated(minor * gp_Vec(x)));
  const gp_Dir z(ElCLib::DN(equator, circle, 1));
  if (!z.IsParallel(axis.Direction(), same_direction)) return std::nullopt;
  const gp_Ax3 axes = axes_about(origin, z, x, axis.Direction());
  const double shift = -equator - full_turn * std::round((middle - equator) / full_turn);
  Elementary found;
  if (is_sphere)
    found.surface = new Geom_SphericalSurface(axes, minor);
  else
    found.surface = new Geom_ToroidalSurface(axes, major, minor);
  found.converted = [shift](const gp_Pnt2d& uv) { return gp_Pnt2d(uv.X(), uv.Y() + shift); };
  return found;
}

std::optional<Elementary> recognise_turned(const Geom_SurfaceOfRevolution& surface, const Range& range) {
  const Handle(Geom_Curve) meridian = untrimmed(surface.BasisCurve());
  if (const auto circle = Handle(Geom_Circle)::DownCast(meridian))
    return turned_circle(circle->Circ(), surface.Axis(), range);
  const auto line = Handle(Geom_Line)::DownCast(meridian);
  if (line.IsNull()) return std::nullopt;
  return Elementary{turned_line(line->Lin(), surface.Axis()), unchanged};
}

std::optional<Elementary> on_plane(const Handle(Geom_Surface) & surface, const Handle(Geom_Plane) & plane) {
  auto converted = [surface, plane](const gp_Pnt2d& uv) {
    double u = 0, v = 0;
    ElSLib::Parameters(plane->Pln(), surface->Value(uv.X(), uv.Y()), u, v);
    return gp_Pnt2d(u, v);
  };
  Elementary found;
  found.surface = plane;
  found.converted = converted;
  return found;
}

std::optional<Elementary> recognise_extruded(const Handle(Geom_SurfaceOfLinearExtrusion) & extruded) {
  const Handle(Geom_Curve) profile = untrimmed(extruded->BasisCurve());
  const gp_Dir along = extruded->Direction();
  if (const auto line = Handle(Geom_Line)::DownCast(profile)) {
    const gp_Lin lin = line->Lin();
    if (lin.Direction().IsParallel(along, same_direction)) return std::nullopt;
    return on_plane(extruded, new Geom_Plane(gp_Ax3(lin.Location(), lin.Direction().Crossed(along), lin.Direction())));
  }
  const auto circle = Handle(Geom_Circle)::DownCast(profile);
  if (circle.IsNull() || !circle->Circ().Axis().Direction().IsParallel(along, same_direction)) return std::nullopt;
  const gp_Ax2 frame = circle->Circ().Position();
  const gp_Ax3 axes = axes_about(frame.Location(), along, frame.XDirection(), frame.Direction());
  return Elementary{new Geom_CylindricalSurface(axes, circle->Radius()), unchanged};
}

gp_Vec normal_of(const Handle(Geom_Surface) & surface, double u, double v) {
  gp_Pnt point;
  gp_Vec xu, xv;
  surface->D1(u, v, point, xu, xv);
  return xu.Crossed(xv);
}

std::optional<Elementary> recognise_flat(const Handle(Geom_Surface) & surface, const Range& range, double tolerance) {
  const GeomLib_IsPlanarSurface flat(surface, tolerance);
  if (!flat.IsPlanar()) return std::nullopt;
  const Handle(Geom_Plane) plane = new Geom_Plane(flat.Plan());
  const gp_Vec normal = normal_of(surface, 0.5 * (range.u0 + range.u1), 0.5 * (range.v0 + range.v1));
  if (normal.Dot(normal_of(plane, 0, 0)) < 0) plane->UReverse();
  return on_plane(surface, plane);
}

/// Where a point of a cylinder or cone is; nothing for the angle at an apex.
struct Place {
  std::optional<double> angle;
  double height = 0;
};
Place place_on(const Handle(Geom_Surface) & surface, const gp_Pnt& point) {
  double u = 0, v = 0;
  if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface)) {
    ElSLib::Parameters(cylinder->Cylinder(), point, u, v);
    return {u, v};
  }
  const gp_Cone cone = Handle(Geom_ConicalSurface)::DownCast(surface)->Cone();
  ElSLib::Parameters(cone, point, u, v);
  const double size = 1 + std::abs(v) + cone.RefRadius();
  if (from_axis(cone.Axis(), point).Magnitude() <= no_distance * size) return {std::nullopt, v};
  return {u, v};
}

/// A spline with straight lines in one direction between arcs about one axis in the other one.
class RuledSpline {
 public:
  RuledSpline(const Handle(Geom_Surface) & surface, const Range& range, bool turns_in_u)
      : surface_(surface), range_(range), turns_in_u_(turns_in_u) {}

  std::optional<Elementary> recognise() const {
    const gp_Pnt start = point(0, 0), end = point(0, 1);
    if (start.Distance(end) <= Precision::Confusion()) return std::nullopt;
    const double height = arc_size(0) >= arc_size(1) ? 0 : 1;
    // A third of the way each, as ends may be one.
    const GC_MakeCircle arc(point(0, height), point(1.0 / 3, height), point(2.0 / 3, height));
    if (!arc.IsDone()) return std::nullopt;
    gp_Ax1 axis = arc.Value()->Circ().Axis();  // points turn about it
    // With u along the lines the normal is kept by turning the other way.
    if (!turns_in_u_) axis.Reverse();
    const Handle(Geom_Surface) found = turned_line(gp_Lin(start, gp_Dir(gp_Vec(start, end))), axis);
    if (found.IsNull()) return std::nullopt;
    const double turn = total_turn(found, height);
    auto converted = [spline = *this, found, turn](const gp_Pnt2d& uv) { return spline.convert(uv, found, turn); };
    return Elementary{found, converted};
  }

 private:
  gp_Pnt point(double around, double along) const {
    const double u = turns_in_u_ ? around : along, v = turns_in_u_ ? along : around;
    return surface_->Value(std::lerp(range_.u0, range_.u1, u), std::lerp(range_.v0, range_.v1, v));
  }

  double arc_size(double along) const { return point(0, along).Distance(point(1.0 / 3, along)); }

  double total_turn(const Handle(Geom_Surface) & found, double height) const {
    double sum = 0, before = 0;
    for (int i = 1; i <= turn_samples; ++i) {
      const double angle = place_on(found, point(double(i) / turn_samples, height)).angle.value_or(before);
      sum += std::remainder(angle - before, full_turn);
      before = angle;
    }
    return sum;
  }

  gp_Pnt2d convert(const gp_Pnt2d& uv, const Handle(Geom_Surface) & found, double turn) const {
    const Place place = place_on(found, surface_->Value(uv.X(), uv.Y()));
    const double share =
        turns_in_u_ ? (uv.X() - range_.u0) / (range_.u1 - range_.u0) : (uv.Y() - range_.v0) / (range_.v1 - range_.v0);
    const double about = (turn < 0 ? full_turn : 0) + share * turn, angle = place.angle.value_or(about);
    return {angle + full_turn * std::round((about - angle) / full_turn), place.height};
  }

  Handle(Geom_Surface) surface_;
  Range range_;
  bool turns_in_u_;
};

/// Whether both are one surface over the face's range.
bool is_same(const Handle(Geom_Surface) & surface, const Elementary& found, const Range& range, double tolerance) {
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const gp_Pnt2d uv(std::lerp(range.u0, range.u1, i / (samples - 1.0)),
                        std::lerp(range.v0, range.v1, j / (samples - 1.0)));
      const gp_Pnt2d there = found.converted(uv);
      const gp_Pnt point = surface->Value(uv.X(), uv.Y()), found_point = found.surface->Value(there.X(), there.Y());
      if (!(point.Distance(found_point) <= tolerance)) return false;
    }
  return true;
}

std::optional<Elementary> proposal(const Handle(Geom_Surface) & surface, const Range& range, double tolerance) {
  if (const auto turned = Handle(Geom_SurfaceOfRevolution)::DownCast(surface)) return recognise_turned(*turned, range);
  if (const auto extruded = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface))
    return recognise_extruded(extruded);
  if (!surface->IsKind(STANDARD_TYPE(Geom_BSplineSurface)) && !surface->IsKind(STANDARD_TYPE(Geom_BezierSurface)))
    return std::nullopt;
  if (auto flat = recognise_flat(surface, range, tolerance)) return flat;
  for (const bool turns_in_u : {true, false})
    if (auto ruled = RuledSpline(surface, range, turns_in_u).recognise();
        ruled && is_same(surface, *ruled, range, tolerance))
      return ruled;
  return std::nullopt;
}

}  // namespace

std::optional<Elementary> recognise_surface(const TopoDS_Face& face, double tolerance) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face, location));
  if (surface.IsNull() || surface->IsKind(STANDARD_TYPE(Geom_ElementarySurface))) return std::nullopt;
  Range range{};
  BRepTools::UVBounds(face, range.u0, range.u1, range.v0, range.v1);
  for (const double end : {range.u0, range.u1, range.v0, range.v1})
    if (!std::isfinite(end) || Precision::IsInfinite(end)) return std::nullopt;
  if (range.u1 <= range.u0 || range.v1 <= range.v0) return std::nullopt;
  std::optional<Elementary> found = proposal(surface, range, tolerance);
  if (!found || found->surface.IsNull() || !is_same(surface, *found, range, tolerance)) return std::nullopt;
  return found;
}

}  // namespace paver
