// Of the file's faces: which edges they use twice, and which of them end where no other does, at a pole; and how their
// loops run.
#include <StepShape_EdgeCurve.hxx>
#include <StepShape_Vertex.hxx>
#include <map>
#include <vector>

#include "brep/occt_shapes_impl.h"
#include "formats/step_impl.h"
#include "formats/transfer_impl.h"
#include "formats/whole_face_impl.h"

namespace paver {
namespace {

/// How many ends of edges that the face uses twice no other edge has: there they turn back at a pole.
int dead_ends(const StepShape_FaceSurface& face) {
  std::map<const Standard_Transient*, std::pair<Handle(StepShape_Edge), int>> uses;
  visit_edges(face, [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound&) {
    const Handle(StepShape_Edge) edge = walked.EdgeElement();
    if (!edge.IsNull()) uses[edge.get()].first = edge, ++uses[edge.get()].second;
  });
  std::map<const Standard_Transient*, int> edges_at;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()}) ++edges_at[end.get()];
  int count = 0;
  for (const auto& [key, use] : uses)
    for (const Handle(StepShape_Vertex) & end : {use.first->EdgeStart(), use.first->EdgeEnd()})
      count += use.second == 2 && edges_at[end.get()] == 1;
  return count;
}

/// The edges of its loops; along the surface's normal where the face is.
std::vector<FileEdge> edges_of(const XSControl_Reader& reader, const StepShape_FaceSurface& face) {
  std::vector<FileEdge> edges;
  visit_edges(face, [&](const StepShape_OrientedEdge& walked, const StepShape_FaceBound& bound) {
    const auto edge = Handle(StepShape_EdgeCurve)::DownCast(walked.EdgeElement());
    if (edge.IsNull()) return;
    const TopoDS_Shape read = shape_of(reader, edge);
    if (read.IsNull() || read.ShapeType() != TopAbs_EDGE) return;
    const int turns = !walked.Orientation() + !bound.Orientation() + !edge->SameSense() + !face.SameSense();
    edges.push_back(file_edge(TopoDS::Edge(read), turns % 2 == 0));
  });
  return edges;
}

}  // namespace

void restore_sides(XSControl_Reader& reader, Shape& shape) {
  std::vector<FileFace> faces;
  for (const Handle(Standard_Transient) & any : entities_of(reader)) {
    const auto entity = Handle(StepShape_FaceSurface)::DownCast(any);
    if (entity.IsNull()) continue;
    const bool is_along = entity->SameSense();
    FileFace face{faces_of(shape_of(reader, entity)), [&reader, entity] { return edges_of(reader, *entity); }, is_along,
                  !is_along, dead_ends(*entity) == 2};
    if (!face.read.empty()) faces.push_back(std::move(face));
  }
  FaceChanges changes(shape.shape);
  restore_faces(faces, changes);
  changes.apply(shape);
}

}  // namespace paver
