#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <algorithm>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// From places of the image's border, on its surface, to the faces' surfaces.
double measured_gap(const Fusion::Image& image, const Workpiece& work) {
  const Handle(IntTools_Context) context = new IntTools_Context;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(image.face);
  double gap = 0;
  for (const TopoDS_Edge& edge : edges_of(image.face)) {
    const EdgeImage border = image_of(edge, image.face);
    if (border.curve.IsNull()) continue;
    for (double share : {0.0, 0.5, 1.0}) {
      const gp_Pnt2d uv = border.uv(share);
      for (int f : image.of) {
        GeomAPI_ProjectPointOnSurf& foot = context->ProjPS(work.faces[f].face);
        foot.Perform(surface->Value(uv.X(), uv.Y()));
        if (foot.IsDone() && foot.NbPoints() > 0) gap = std::max(gap, foot.LowerDistance());
      }
    }
  }
  return gap;
}

}  // namespace

double closed_gap(double tolerance) { return tolerance > 2 * Precision::Confusion() ? tolerance : 0; }

double closed_gap(const Fusion::Image& image, const Workpiece& work, double fusion_tolerance) {
  double gap = 0;
  for (const TopoDS_Edge& edge : edges_of(image.face)) gap = std::max(gap, closed_gap(BRep_Tool::Tolerance(edge)));
  return gap > fusion_tolerance ? std::min(gap, std::max(fusion_tolerance, measured_gap(image, work))) : gap;
}

}  // namespace paver
