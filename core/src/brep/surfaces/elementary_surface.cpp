// Plane, cylinder, cone, sphere and torus in closed form, several times faster than the kernel's evaluation.
// Parameters and axes as in OpenCASCADE (ElSLib). The placement of the face is applied to the axes, not to (u, v): a
// placement that scales gives axes longer than one, and a left-handed system stays left-handed.
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <cmath>
#include <numbers>

#include "brep/occt_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// The numbers behind a plane, cylinder, cone, sphere or torus. With c = cos u, s = sin u and r = radius a point is
///   plane    origin + u x + v y
///   cylinder origin + r (c x + s y) + v z
///   cone     origin + (r + v sin half_angle)(c x + s y) + v cos half_angle z
///   sphere   origin + r cos v (c x + s y) + r sin v z
///   torus    origin + (r + minor_radius cos v)(c x + s y) + minor_radius sin v z
/// x, y, z are orthogonal; of length one unless the face's placement scales; left-handed where the file says so.
struct ElementarySurface {
  Vec3 origin, x, y, z;
  double radius = 0;        ///< mm
  double minor_radius = 0;  ///< mm, torus only
  double half_angle = 0;    ///< radians, cone only
};

class PlaneSurface : public Surface {
 public:
  explicit PlaneSurface(const ElementarySurface& shape) : shape_(shape) {}
  Vec3 point(Vec2 uv) const override { return shape_.origin + uv.x * shape_.x + uv.y * shape_.y; }
  SurfaceSlope slope(Vec2 uv) const override { return {point(uv), shape_.x, shape_.y}; }
  SurfaceJet jet(Vec2 uv) const override { return {slope(uv)}; }
  SurfaceKind kind() const override { return SurfaceKind::plane; }
  Vec2 period() const override { return {0, 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<PlaneSurface>(*this); }

 private:
  ElementarySurface shape_;
};

/// Distance from the axis, height along it, and their derivatives by v.
struct ProfilePoint {
  double r = 0, z = 0, r1 = 0, z1 = 0, r2 = 0, z2 = 0;
};

/// A profile turned about the z axis.
template <SurfaceKind Kind>
class TurnedSurface : public Surface {
 public:
  explicit TurnedSurface(const ElementarySurface& shape)
      : shape_(shape), sine_(std::sin(shape.half_angle)), cosine_(std::cos(shape.half_angle)) {}

  Vec3 point(Vec2 uv) const override {
    ProfilePoint p = profile(uv.y);
    return shape_.origin + p.r * radial(uv.x) + p.z * shape_.z;
  }
  SurfaceSlope slope(Vec2 uv) const override {
    ProfilePoint p = profile(uv.y);
    Vec3 e = radial(uv.x);
    return {shape_.origin + p.r * e + p.z * shape_.z, p.r * tangential(uv.x), p.r1 * e + p.z1 * shape_.z};
  }
  SurfaceJet jet(Vec2 uv) const override {
    ProfilePoint p = profile(uv.y);
    Vec3 e = radial(uv.x), t = tangential(uv.x);
    return {{shape_.origin + p.r * e + p.z * shape_.z, p.r * t, p.r1 * e + p.z1 * shape_.z},
            -p.r * e,
            p.r1 * t,
            p.r2 * e + p.z2 * shape_.z};
  }
  SurfaceKind kind() const override { return Kind; }
  Vec2 period() const override { return {full_turn, Kind == SurfaceKind::torus ? full_turn : 0}; }
  std::unique_ptr<Surface> clone() const override { return std::make_unique<TurnedSurface>(*this); }

 private:
  ProfilePoint profile(double v) const {
    if constexpr (Kind == SurfaceKind::cylinder) {
      return {shape_.radius, v, 0, 1, 0, 0};
    } else if constexpr (Kind == SurfaceKind::cone) {
      return {shape_.radius + v * sine_, v * cosine_, sine_, cosine_, 0, 0};
    } else if constexpr (Kind == SurfaceKind::sphere) {
      double s = shape_.radius * std::sin(v), c = shape_.radius * std::cos(v);
      return {c, s, -s, c, -c, -s};
    } else {
      double s = shape_.minor_radius * std::sin(v), c = shape_.minor_radius * std::cos(v);
      return {shape_.radius + c, s, -s, c, -c, -s};
    }
  }
  Vec3 radial(double u) const { return std::cos(u) * shape_.x + std::sin(u) * shape_.y; }
  Vec3 tangential(double u) const { return -std::sin(u) * shape_.x + std::cos(u) * shape_.y; }

  ElementarySurface shape_;
  double sine_, cosine_;  // of the half angle
};

ElementarySurface placed_axes(const gp_Ax3& axes, const gp_Trsf& placement) {
  gp_XYZ origin = axes.Location().XYZ();
  placement.Transforms(origin);
  // The vectorial part holds scale and mirror too.
  auto turned = [&](const gp_Dir& d) { return to_vec(d.XYZ().Multiplied(placement.VectorialPart())); };
  ElementarySurface e;
  e.origin = to_vec(origin);
  e.x = turned(axes.XDirection());
  e.y = turned(axes.YDirection());
  e.z = turned(axes.Direction());
  return e;
}

}  // namespace

std::unique_ptr<Surface> make_elementary_surface(const Handle(Geom_Surface) & surface, const gp_Trsf& placement) {
  Handle(Geom_ElementarySurface) found = Handle(Geom_ElementarySurface)::DownCast(surface);
  if (found.IsNull()) return nullptr;
  ElementarySurface e = placed_axes(found->Position(), placement);
  if (found->IsKind(STANDARD_TYPE(Geom_Plane))) return std::make_unique<PlaneSurface>(e);
  if (auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(surface); !cylinder.IsNull()) {
    e.radius = cylinder->Radius();
    return std::make_unique<TurnedSurface<SurfaceKind::cylinder>>(e);
  }
  if (auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
    e.radius = cone->RefRadius();
    e.half_angle = cone->SemiAngle();
    return std::make_unique<TurnedSurface<SurfaceKind::cone>>(e);
  }
  if (auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface); !sphere.IsNull()) {
    e.radius = sphere->Radius();
    return std::make_unique<TurnedSurface<SurfaceKind::sphere>>(e);
  }
  if (auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface); !torus.IsNull()) {
    e.radius = torus->MajorRadius();
    e.minor_radius = torus->MinorRadius();
    return std::make_unique<TurnedSurface<SurfaceKind::torus>>(e);
  }
  return nullptr;
}

}  // namespace paver
