// Evaluators of the geometry under faces and edges. Only brep/*.cpp includes OpenCASCADE.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "paver/vec.h"

namespace paver {

/// All but `other` are evaluated in closed form.
enum class SurfaceKind { plane, cylinder, cone, sphere, torus, other };

/// Point and first derivatives.
struct SurfaceSlope {
  Vec3 x, u, v;
};
struct CurveSlope {
  Vec3 x, t;
};
/// With the second derivatives.
struct SurfaceJet : SurfaceSlope {
  Vec3 uu{}, uv{}, vv{};
};
struct CurveJet : CurveSlope {
  Vec3 tt{};
};

/// One face's surface in its own parameters. An evaluator caches the last span, so each task clones its own.
/// Every value is finite: beyond the ends of a bounded surface it is continued linearly, across a closed one wrapped.
/// Throws Error{face_failed} where the surface has no value.
class Surface {
 public:
  virtual ~Surface() = default;
  virtual Vec3 point(Vec2 uv) const = 0;
  virtual SurfaceSlope slope(Vec2 uv) const = 0;
  virtual SurfaceJet jet(Vec2 uv) const = 0;
  /// On the side of the cross product of the derivatives, of length one; zero where these are parallel.
  Vec3 normal(Vec2 uv) const {
    const SurfaceSlope at = slope(uv);
    return unit(cross(at.u, at.v));
  }
  virtual SurfaceKind kind() const = 0;
  /// Period in u and v where the surface is closed there (periodic or ends that coincide), else 0.
  virtual Vec2 period() const = 0;
  virtual std::unique_ptr<Surface> clone() const = 0;
};

/// A 3-D curve; has no cache, so threads may share it.
class Curve {
 public:
  virtual ~Curve() = default;
  virtual Vec3 point(double t) const = 0;
  virtual CurveSlope slope(double t) const = 0;
  virtual CurveJet jet(double t) const = 0;
};

/// An edge's image in a face's (u, v), over the edge's own parameter; has no cache, so threads may share it.
class ParameterCurve {
 public:
  virtual ~ParameterCurve() = default;
  virtual Vec2 uv(double t) const = 0;
};

template <class F>
class ParameterFunction final : public ParameterCurve {
 public:
  explicit ParameterFunction(F f) : f_(std::move(f)) {}
  Vec2 uv(double t) const override { return f_(t); }

 private:
  F f_;
};

/// The image whose (u, v) at a parameter `f` gives.
template <class F>
std::shared_ptr<const ParameterCurve> image_by(F f) {
  return std::make_shared<ParameterFunction<F>>(std::move(f));
}

/// The whole number of periods nearest to `gap`; 0 where there is no period.
inline Vec2 whole_periods(Vec2 gap, Vec2 period) {
  auto whole = [](double length, double one) { return one > 0 ? one * std::round(length / one) : 0.0; };
  return {whole(gap.x, period.x), whole(gap.y, period.y)};
}

/// The image of `uv` a whole number of periods away that is nearest to `to`.
inline Vec2 nearest_image(Vec2 uv, Vec2 to, Vec2 period) {
  if (period.x > 0) uv.x += period.x * std::round((to.x - uv.x) / period.x);
  if (period.y > 0) uv.y += period.y * std::round((to.y - uv.y) / period.y);
  return uv;
}

}  // namespace paver
