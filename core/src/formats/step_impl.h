// What a STEP file has and the kernel leaves out, or reads otherwise than it is meant.
#pragma once

#include <STEPControl_Reader.hxx>
#include <Standard_Transient.hxx>
#include <StepShape_EdgeLoop.hxx>
#include <StepShape_FaceBound.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_OrientedEdge.hxx>
#include <string>
#include <vector>

#include "brep/shape_impl.h"

namespace paver {

/// Labels of shapes of which nothing came, of positions of parts that are not as the file has them (a scale, a mirror
/// image or no placement at all), and of units of length that are not as stated. After the transfer.
std::vector<std::string> step_losses(STEPControl_Reader& reader);

/// Labels of solids that came without a closed shell.
std::vector<std::string> open_solids(STEPControl_Reader& reader);

/// Meridians of spheres that miss the pole they end at by less than 3e-5 of the radius, as where the file has few
/// decimals, go through it; so do circles and ellipses that are turned about an axis beside their plane. Before the
/// transfer.
void lead_meridians_to_poles(const XSControl_Reader& reader);

/// visit(walked edge, its bound) for the edges of the loops of a face, in their order.
template <class Visit>
void visit_edges(const StepShape_FaceSurface& face, Visit visit) {
  for (int b = 1; b <= face.NbBounds(); ++b) {
    const Handle(StepShape_FaceBound) bound = face.BoundsValue(b);
    const auto loop = Handle(StepShape_EdgeLoop)::DownCast(bound->Bound());
    for (int e = 1; !loop.IsNull() && e <= loop->NbEdgeList(); ++e) visit(*loop->EdgeListValue(e), *bound);
  }
}

/// Faces that reading puts on the wrong side of their loops are made anew (`restore_faces`). A file walks along a
/// periodic edge to a pole and back, or has no periodic edges at all. Where all loops of a face meet its periodic edge,
/// as with a ball that has a rod along its x axis, the reader drops that edge, and the poles with it, and takes the
/// loop for the border of the small piece. To be called last: other results of reading then no longer have the shape's
/// faces.
void restore_sides(XSControl_Reader& reader, Shape& shape);

/// What the file calls its units of length, or "not stated".
std::string stated_unit(STEPControl_Reader& reader);

/// Of a representation of a shape, whether it states one unit of length that the kernel understands: that takes
/// millimetres where it finds none, the last of several, and of a unit that is defined by another than an SI unit only
/// the number (ISO 10303-41, conversion_based_unit). True for all other entities.
bool is_measured_as_stated(const Handle(Standard_Transient) & entity);

/// Of a representation of a shape, mm; 0 for other entities, and where the kernel understands none.
double largest_unit(const Handle(Standard_Transient) & entity);

}  // namespace paver
