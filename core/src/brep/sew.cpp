// Sewing: edges of one face only that coincide with such an edge of another face become one common edge.
// Solids are sewn each by itself: solids that touch stay apart, as they were drawn. Faces without a free edge keep
// their edges as they are, so sharing in the input is never undone. Faces keep their order and number.
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <map>

#include "brep/occt_impl.h"
#include "brep/workpiece_impl.h"

namespace paver {
namespace {

// The default tolerance is the least of three:
// so little of an element that nobody sees it;
constexpr double length_share = 0.01;
// what files without topology need: in the models at hand parts that fit do so within 1e-8 of the diagonal, and
// from 1e-4 on thin open slits (tips, trailing edges) are closed that are meant to be open;
constexpr double diagonal_share = 1e-5;
// never so much that an edge collapses, unless it is a sliver anyhow.
constexpr double edge_share = 0.25;
constexpr double sliver_share = 1e-6;  // of the diagonal

double default_tolerance(const EdgeUses& uses, double target_length, double diagonal) {
  double tolerance = std::min(length_share * target_length, diagonal_share * diagonal);
  for (int i = 1; i <= uses.edges.Extent(); ++i) {
    if (!uses.is_free(i)) continue;
    double length = edge_length(TopoDS::Edge(uses.edges(i)));
    if (length > sliver_share * diagonal) tolerance = std::min(tolerance, edge_share * length);
  }
  return tolerance;
}

long free_count(const EdgeUses& uses) {
  long count = 0;
  for (int i = 1; i <= uses.edges.Extent(); ++i) count += uses.is_free(i);
  return count;
}

bool has_free_edge(const TopoDS_Face& face, const EdgeUses& uses) {
  for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
    int index = uses.edges.FindIndex(edges.Current());
    if (index > 0 && uses.is_free(index)) return true;
  }
  return false;
}

/// Indices of faces to sew, per solid (-1: faces without one); only groups that have a free edge.
std::map<int, std::vector<int>> groups_to_sew(const Workpiece& work, const EdgeUses& uses) {
  std::map<int, std::vector<int>> groups;
  std::map<int, bool> is_open;
  for (std::size_t i = 0; i < work.faces.size(); ++i) {
    const WorkFace& face = work.faces[i];
    if (!face.has_area || !face.fault.empty()) continue;
    groups[face.solid].push_back(static_cast<int>(i));
    if (has_free_edge(face.face, uses)) is_open[face.solid] = true;
  }
  std::erase_if(groups, [&](const auto& group) { return !is_open[group.first]; });
  return groups;
}

/// Edges that sewing replaced keep the numbers of those they stand for.
void note_replaced_edges(Workpiece& work, const std::vector<TopoDS_Face>& faces, const BRepBuilderAPI_Sewing& sewing) {
  TopTools_IndexedMapOfShape edges;
  for (const TopoDS_Face& face : faces) TopExp::MapShapes(face, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    TopoDS_Shape image = sewing.ModifiedSubShape(edges(i));
    if (!image.IsNull() && !image.IsSame(edges(i))) add_edge_origins(work, image, edge_origins(work, edges(i)));
  }
}

void sew_group(Workpiece& work, const std::vector<int>& group, SewResult& result, Progress& progress) {
  BRepBuilderAPI_Sewing sewing(result.tolerance);
  std::vector<TopoDS_Face> before;
  for (int i : group) before.push_back(work.faces[static_cast<std::size_t>(i)].face);
  for (const TopoDS_Face& face : before) sewing.Add(face);
  Handle(OcctProgress) indicator = new OcctProgress(progress, sew_units * static_cast<long>(group.size()));
  sewing.Perform(indicator->Start());
  indicator->finish();
  note_replaced_edges(work, before, sewing);
  for (int i : group) {
    WorkFace& face = work.faces[static_cast<std::size_t>(i)];
    TopoDS_Shape image = sewing.IsModified(face.face) ? sewing.Modified(face.face) : face.face;
    if (!image.IsNull() && image.ShapeType() == TopAbs_FACE) {
      face.face = TopoDS::Face(image);
      continue;
    }
    face.has_area = false;
    result.lost_faces.push_back(i);
  }
}

}  // namespace

SewResult sew(Workpiece& work, double tolerance, double target_length, Progress& progress) {
  SewResult result;
  EdgeUses uses = count_uses(work.faces);
  result.free_before = result.free_after = free_count(uses);
  long units = sew_units * static_cast<long>(work.faces.size());
  if (result.free_before == 0 || tolerance == 0) {
    progress.advance(units);
    return result;
  }
  result.tolerance = tolerance > 0 ? tolerance : default_tolerance(uses, target_length, work.diagonal);
  copy_shape(work);
  auto as_read = work.faces;
  for (const auto& [solid, group] : groups_to_sew(work, count_uses(work.faces))) {
    sew_group(work, group, result, progress);
    units -= sew_units * static_cast<long>(group.size());
  }
  result.free_after = free_count(count_uses(work.faces));
  if (result.free_after < result.free_before) {
    work.is_rebuilt = true;
  } else {
    // Nothing fitted: keep the faces as they were, and with them the names of their edges.
    work.faces = as_read;
    work.replaced_edges.Clear();
    result = {0, result.free_before, result.free_before, {}};
  }
  progress.advance(units);
  return result;
}

}  // namespace paver
