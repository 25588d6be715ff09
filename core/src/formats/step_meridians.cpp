// Where a file has rounded numbers, meridians of spheres miss the pole that they lead to, and the longitude of their
// last piece turns by any angle: the kernel's image of such an edge is nowhere near it, or it makes loops of the
// border.
#include <StepGeom_Axis2Placement3d.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_Circle.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_SphericalSurface.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_VertexPoint.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <optional>
#include <vector>

#include "formats/step_impl.h"
#include "formats/transfer_impl.h"

namespace paver {
namespace {

// Of the radius. About 1e-5 of the ball's diagonal: what is nearer comes from rounded numbers, as between parts.
constexpr double most_rounded = 3e-5;
constexpr double exact = 1e-12;

std::optional<gp_Pnt> point_of(const Handle(StepGeom_CartesianPoint) & point) {
  if (point.IsNull() || point->NbCoordinates() != 3) return std::nullopt;
  return gp_Pnt(point->CoordinatesValue(1), point->CoordinatesValue(2), point->CoordinatesValue(3));
}

std::optional<gp_Dir> direction_of(const Handle(StepGeom_Direction) & direction) {
  if (direction.IsNull() || direction->NbDirectionRatios() != 3) return std::nullopt;
  const gp_XYZ ratios(direction->DirectionRatiosValue(1), direction->DirectionRatiosValue(2),
                      direction->DirectionRatiosValue(3));
  return ratios.Modulus() > gp::Resolution() ? std::optional(gp_Dir(ratios)) : std::nullopt;
}

Handle(TColStd_HArray1OfReal) numbers(const gp_XYZ& of) {
  Handle(TColStd_HArray1OfReal) values = new TColStd_HArray1OfReal(1, 3);
  for (int i = 1; i <= 3; ++i) values->SetValue(i, of.Coord(i));
  return values;
}

/// An axis placement.
struct Frame {
  Handle(StepGeom_Axis2Placement3d) placement;
  gp_Pnt origin;
  gp_Dir axis;
};

std::optional<Frame> frame_of(const Handle(StepGeom_Axis2Placement3d) & placement) {
  if (placement.IsNull() || !placement->HasAxis()) return std::nullopt;
  const std::optional<gp_Pnt> origin = point_of(placement->Location());
  const std::optional<gp_Dir> axis = direction_of(placement->Axis());
  if (!origin || !axis) return std::nullopt;
  return Frame{placement, *origin, *axis};
}

/// Puts a circle about this place, into a plane that has `axis` in it. Others may have its placement, too.
void place(StepGeom_Circle& circle, const Frame& frame, const Handle(StepGeom_CartesianPoint) & at,
           const gp_Dir& axis) {
  const gp_Dir normal(frame.axis.XYZ() - frame.axis.Dot(axis) * axis.XYZ());
  Handle(StepGeom_Direction) direction = new StepGeom_Direction;
  direction->Init(frame.placement->Axis()->Name(), numbers(normal.XYZ()));
  Handle(StepGeom_Axis2Placement3d) placement = new StepGeom_Axis2Placement3d;
  placement->Init(frame.placement->Name(), at, true, direction, frame.placement->HasRefDirection(),
                  frame.placement->RefDirection());
  StepGeom_Axis2Placement position;
  position.SetValue(placement);
  circle.SetPosition(position);
}

Handle(StepGeom_Circle) circle_of(const StepShape_EdgeCurve& edge) {
  Handle(StepGeom_Curve) curve = edge.EdgeGeometry();
  if (const auto on_surface = Handle(StepGeom_SurfaceCurve)::DownCast(curve); !on_surface.IsNull())
    curve = on_surface->Curve3d();
  return Handle(StepGeom_Circle)::DownCast(curve);
}

class Sphere {
 public:
  Sphere(Frame frame, double radius) : frame_(std::move(frame)), radius_(radius) {}

  /// Where one of its meridians misses a pole by rounding both are moved so that it does not.
  void mend(const StepShape_EdgeCurve& edge) const {
    const Handle(StepGeom_Circle) circle = circle_of(edge);
    if (circle.IsNull() || edge.EdgeStart() == edge.EdgeEnd()) return;
    const std::optional<Frame> frame = frame_of(circle->Position().Axis2Placement3d());
    if (!frame) return;
    const double off = std::max({frame->origin.Distance(frame_.origin), std::fabs(circle->Radius() - radius_),
                                 std::fabs(frame->axis.Dot(frame_.axis)) * radius_});
    if (off > most_rounded * radius_) return;
    bool leads_to_pole = false, is_off = off > exact * radius_;
    for (const Handle(StepShape_Vertex) & end : {edge.EdgeStart(), edge.EdgeEnd()}) {
      const double missed = move_to_pole(Handle(StepShape_VertexPoint)::DownCast(end));
      leads_to_pole = leads_to_pole || missed <= most_rounded * radius_;
      is_off = is_off || (missed <= most_rounded * radius_ && missed > exact * radius_);
    }
    if (!leads_to_pole || !is_off) return;
    place(*circle, *frame, frame_.placement->Location(), frame_.axis);
    circle->SetRadius(radius_);
  }

 private:
  /// Gives how far from the nearer pole it was; what is farther than by rounding stays.
  double move_to_pole(const Handle(StepShape_VertexPoint) & vertex) const {
    if (vertex.IsNull()) return INFINITY;
    const auto point = Handle(StepGeom_CartesianPoint)::DownCast(vertex->VertexGeometry());
    const std::optional<gp_Pnt> at = point_of(point);
    if (!at) return INFINITY;
    const double side = gp_Vec(frame_.origin, *at).Dot(gp_Vec(frame_.axis)) < 0 ? -1 : 1;
    const gp_Pnt pole = frame_.origin.Translated(side * radius_ * gp_Vec(frame_.axis));
    const double missed = pole.Distance(*at);
    if (missed > exact * radius_ && missed <= most_rounded * radius_) {
      Handle(StepGeom_CartesianPoint) moved = new StepGeom_CartesianPoint;
      moved->Init(point->Name(), numbers(pole.XYZ()));
      vertex->SetVertexGeometry(moved);
    }
    return missed;
  }

  Frame frame_;
  double radius_;
};

}  // namespace

void lead_meridians_to_poles(const XSControl_Reader& reader) {
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto face = Handle(StepShape_FaceSurface)::DownCast(any);
    if (face.IsNull()) continue;
    const auto surface = Handle(StepGeom_SphericalSurface)::DownCast(face->FaceGeometry());
    const std::optional<Frame> frame = surface.IsNull() ? std::nullopt : frame_of(surface->Position());
    if (!frame) continue;
    const Sphere sphere(*frame, surface->Radius());
    visit_edges(*face, [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound&) {
      const auto edge = Handle(StepShape_EdgeCurve)::DownCast(walked.EdgeElement());
      if (!edge.IsNull()) sphere.mend(*edge);
    });
  }
}

}  // namespace paver
