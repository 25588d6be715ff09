// Two faces on one torus, each once round its tube, stay two where their loops walk the periodic edge along it first,
// as those of STEP files do: the kernel builds one of them with that edge's images exchanged.
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>

#include "brep/connecting/connect_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

/// The loop from its periodic edge against that on; null where it has that first, or does not have just one.
TopoDS_Wire with_edge_back_first(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<TopoDS_Edge> edges = edges_of(wire);
  auto is_periodic = [&](const TopoDS_Edge& edge) { return BRep_Tool::IsClosed(edge, face); };
  const auto first = std::ranges::find_if(edges, is_periodic);
  if (std::ranges::count_if(edges, is_periodic) != 2 || first->Orientation() != TopAbs_FORWARD) return {};
  std::rotate(edges.begin(), std::find_if(first + 1, edges.end(), is_periodic), edges.end());
  TopoDS_Wire ordered;
  BRep_Builder builder;
  builder.MakeWire(ordered);
  for (const TopoDS_Edge& edge : edges) builder.Add(ordered, edge);
  ordered.Closed(true);
  return ordered;
}

}  // namespace

void order_tori(Workpiece& work, const std::vector<int>& parts) {
  const std::vector<char> is_member = marked_parts(work, parts);
  for (WorkFace& face : work.faces) {
    if (!face.is_usable() || face.uses.empty() || !is_member[face.uses[0].part]) continue;
    const TopoDS_Face plain = forward(face.face);
    const std::vector<TopoDS_Wire> wires = wires_of(plain);
    if (wires.size() != 1 || Handle(Geom_ToroidalSurface)::DownCast(untrimmed(BRep_Tool::Surface(plain))).IsNull())
      continue;
    const TopoDS_Wire ordered = with_edge_back_first(wires[0], plain);
    if (ordered.IsNull()) continue;
    face.face = TopoDS::Face(face_with(plain, ordered, wires[0]).Oriented(face.face.Orientation()));
    work.is_rebuilt = true;
  }
}

}  // namespace paver
