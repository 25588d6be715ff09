// Planes, cylinders, cones, spheres and tori, lines and arcs, that files write as something else: IGES has turned lines
// and circles for them, programs that know splines only write splines. The kernel connects those up to 40 times as
// slowly, and these are evaluated in closed form, too.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <functional>
#include <optional>

#include "brep/connecting/workpiece_impl.h"

namespace paver {

/// A surface that a face can have in place of its own, in the same coordinates.
struct Elementary {
  Handle(Geom_Surface) surface;
  std::function<gp_Pnt2d(const gp_Pnt2d&)> converted;  ///< parameters, from those on the face's own surface
};

/// Of a FORWARD face; nothing where its surface is none within `tolerance` (mm), or has that form already.
std::optional<Elementary> recognise_surface(const TopoDS_Face& face, double tolerance);

/// A line by its length or an arc by its angle, from 0 to `last`.
struct PlainCurve {
  Handle(Geom_Curve) curve;
  TopLoc_Location location;
  double last = 0;
};

/// Of a FORWARD edge whose curve is a spline; nothing where that is no line or arc within `tolerance` (mm).
std::optional<PlainCurve> recognise_curve(const TopoDS_Edge& edge, double tolerance);

/// Gives faces and edges these surfaces and curves, on a copy when there is anything to do. Images are made anew and
/// checked before; what has none that fits stays as it is.
void recognise(Workpiece& work);

}  // namespace paver
