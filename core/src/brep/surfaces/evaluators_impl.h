// Makes the evaluators of surface.h from OpenCASCADE's faces and edges.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <gp_Trsf.hxx>
#include <memory>
#include <optional>
#include <vector>

#include "brep/surfaces/surface.h"

namespace paver {

/// The surface under trims and within its location. Ends of a B-spline that lie within `closure_tolerance` (mm) of each
/// other make it closed. Null when the face has no surface.
std::unique_ptr<Surface> make_surface(const TopoDS_Face& face, double closure_tolerance);

/// Closed form of plane, cylinder, cone, sphere and torus; null for other surfaces.
std::unique_ptr<Surface> make_elementary_surface(const Handle(Geom_Surface) & surface, const gp_Trsf& placement);

/// The edge's 3-D curve, or its image on a surface where it has only that; null when it has neither.
std::shared_ptr<const Curve> make_curve(const TopoDS_Edge& edge);

/// Points of a curve from t0 to t1, also where that is backwards.
struct SampledCurve {
  std::shared_ptr<const Curve> curve;
  std::vector<double> t;
  std::vector<Vec3> points;
};
SampledCurve sampled(std::shared_ptr<const Curve> curve, double t0, double t1, int pieces);
/// Of its chords.
double length_of(const SampledCurve& line);

/// Distance of x from the curve behind the chord that ends at point k and its neighbours, by some steps from `t`.
double distance_near(const SampledCurve& line, std::size_t k, double t, int steps, Vec3 x);
/// The same behind the chord that is nearest to x.
double distance_to(const SampledCurve& line, int steps, Vec3 x);

/// The edge's image in the face's (u, v), over the edge's own range t0..t1; of a periodic edge the image on the side
/// that edge.Orientation() says. `face` must be FORWARD. Null when there is none.
std::shared_ptr<const ParameterCurve> make_parameter_curve(const TopoDS_Edge& edge, const TopoDS_Face& face, double t0,
                                                           double t1);

/// Image by projection of `curve` onto the face, near the image `rough`: for files whose images run at another pace
/// than their curves. Null when the surface cannot be evaluated.
std::shared_ptr<const ParameterCurve> make_projected_image(const TopoDS_Face& face, std::shared_ptr<const Curve> curve,
                                                           const ParameterCurve& rough, double t0, double t1);

/// The image elsewhere in (u, v), for surfaces that are periodic.
std::shared_ptr<const ParameterCurve> make_shifted_image(std::shared_ptr<const ParameterCurve> image, Vec2 shift);

/// The image with its ends at the feet of the vertices `ends`, where those are more than `allowed` off and the feet are
/// nearer by half: for vertices that lie beside their edges. `off`: the larger of these distances, where it grows. Null
/// where there is nothing to change.
std::shared_ptr<const ParameterCurve> make_image_with_ends(const TopoDS_Face& face,
                                                           std::shared_ptr<const ParameterCurve> image, double t0,
                                                           double t1, const std::array<Vec3, 2>& ends, double allowed,
                                                           double& off);

/// One piece of the border of a face.
struct BorderImage {
  std::shared_ptr<const ParameterCurve> image;
  double t0 = 0, t1 = 0;
  bool is_reversed = false;      ///< runs from t1 to t0
  std::vector<double> breaks{};  ///< t0, t1 and what lies between them where it may have a bend; empty: unknown
};

/// Area of the part of a face's surface that lies to the left of the border in (u, v), to about 1e-6; negative of what
/// lies to the right. Nothing where the border ends at another v than it begins, or a value is not finite.
std::optional<double> area_within(const TopoDS_Face& face, const Surface& surface,
                                  const std::vector<BorderImage>& border);

/// The same by the images that the face itself has; nothing where one is missing or something has no value, too.
std::optional<double> area_within_images(const TopoDS_Face& face);

/// Straight line from `a` at t0 to `b` at t1: stands in for the missing image of a pole.
std::shared_ptr<const ParameterCurve> make_straight_parameter_curve(Vec2 a, Vec2 b, double t0, double t1);

}  // namespace paver
