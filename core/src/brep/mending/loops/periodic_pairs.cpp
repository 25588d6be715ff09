// A torus whose loop has two edges for each of its periodic ones, as readers leave them that go by images alone: sewing
// joins these, but not those that are whole circles.
#include <BRepTools_ReShape.hxx>
#include <BRep_Builder.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "brep/mending/mend_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

constexpr double same_share = 1e-6;  // of a period, or of the diagonal: in one place

/// From one image to the other, which runs back, where they are the same a whole number of periods apart.
std::optional<gp_Vec2d> shift_between(const EdgeImage& image, const EdgeImage& back, const gp_Vec2d& periods) {
  const gp_Vec2d gap(image.uv(0.5), back.uv(0.5));
  const gp_Vec2d shift(periods.X() * std::round(gap.X() / periods.X()),
                       periods.Y() * std::round(gap.Y() / periods.Y()));
  if (shift.Magnitude() == 0) return std::nullopt;
  for (const double share : {0.0, 0.25, 0.5, 1.0}) {
    const gp_Vec2d off = gp_Vec2d(image.uv(share), back.uv(1 - share)) - shift;
    if (std::abs(off.X()) > same_share * periods.X() || std::abs(off.Y()) > same_share * periods.Y())
      return std::nullopt;
  }
  return shift;
}

}  // namespace

std::vector<PeriodicPair> find_periodic_pairs(const TopoDS_Face& face, double diagonal) {
  const Handle(Geom_Surface) surface = untrimmed(BRep_Tool::Surface(face));
  if (surface.IsNull() || !surface->IsUPeriodic() || !surface->IsVPeriodic()) return {};
  const gp_Vec2d periods(surface->UPeriod(), surface->VPeriod());
  std::vector<TopoDS_Edge> left;
  for (const TopoDS_Edge& edge : edges_of(face))
    if (!BRep_Tool::Degenerated(edge) && !BRep_Tool::IsClosed(edge, face) && !image_of(edge, face).curve.IsNull())
      left.push_back(edge);
  auto are_near = [&](const std::array<TopoDS_Vertex, 2>& ends, const std::array<TopoDS_Vertex, 2>& others) {
    return std::ranges::equal(ends, others, [&](const TopoDS_Vertex& one, const TopoDS_Vertex& other) {
      return BRep_Tool::Pnt(one).Distance(BRep_Tool::Pnt(other)) < same_share * diagonal;
    });
  };
  std::vector<PeriodicPair> pairs;
  while (!left.empty()) {
    PeriodicPair pair{left.back(), {}, {}, {}, {}};
    left.pop_back();
    pair.ends = {TopExp::FirstVertex(pair.edge), TopExp::LastVertex(pair.edge)};
    for (const TopoDS_Edge& back : left) {
      pair.back = back;
      pair.back_ends = {TopExp::FirstVertex(back), TopExp::LastVertex(back)};
      EdgeImage image = image_of(back, face);
      if (pair.is_turned())
        std::swap(pair.back_ends[0], pair.back_ends[1]);
      else
        std::swap(image.first, image.last);
      if (!are_near(pair.ends, pair.back_ends)) continue;
      const auto shift = shift_between(image_of(pair.edge, face), image, periods);
      if (!shift) continue;
      pair.shift = *shift;
      pairs.push_back(pair);
      std::erase_if(left, [&](const TopoDS_Edge& done) { return done.IsSame(pair.back); });
      break;
    }
  }
  return pairs;
}

TopoDS_Face with_periodic_edges(const TopoDS_Face& face, const std::vector<PeriodicPair>& pairs) {
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = BRep_Tool::Surface(face, location);
  BRepTools_ReShape change;
  for (const PeriodicPair& pair : pairs) {
    Handle(Geom2d_Curve) own = image_of(pair.edge, face).curve;
    auto shifted = Handle(Geom2d_Curve)::DownCast(own->Translated(pair.shift));
    if (pair.edge.Orientation() == TopAbs_REVERSED) std::swap(own, shifted);
    BRep_Builder().UpdateEdge(pair.edge, own, shifted, surface, location, BRep_Tool::Tolerance(pair.edge));
    for (int k : {0, 1})
      if (!pair.ends[k].IsSame(pair.back_ends[k]))
        change.Replace(pair.back_ends[k], pair.ends[k].Oriented(pair.back_ends[k].Orientation()));
    const TopoDS_Edge edge = forward(pair.edge);
    change.Replace(forward(pair.back), edge.Oriented(pair.is_turned() ? TopAbs_REVERSED : TopAbs_FORWARD));
  }
  return TopoDS::Face(change.Apply(face));
}

}  // namespace paver
