// Points in which faces of two parts touch: a ball on a plate, the end of a rod on a ball. The kernel finds those on
// edges and poles; inside both faces it depends on rounding whether they meet at all.
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Builder.hxx>
#include <algorithm>

#include "brep/connecting/connect_impl.h"
#include "brep/connecting/near/face_cells_impl.h"

namespace paver {
namespace {

constexpr double same_share = 1e-4;     // of the diagonal: points nearer each other are one
constexpr int most_points_of_pair = 4;  // more are places of a line

bool may_touch_in_points(const TopoDS_Face& one, const TopoDS_Face& two, double tolerance) {
  PartPiece first(one, 0.5 * tolerance), second(two, 0.5 * tolerance);
  return !first.is_level_with(second) && !first.is_free_form() && !second.is_free_form() && may_touch(first, second);
}

}  // namespace

std::vector<TopoDS_Vertex> find_touching_points(const Workpiece& work, const std::vector<PartPair>& pairs,
                                                double tolerance, const Progress& progress) {
  std::vector<TopoDS_Vertex> found;
  if (pairs.empty()) return found;
  auto add = [&](const gp_Pnt& at, double gap) {
    if (std::ranges::any_of(found, [&](const TopoDS_Vertex& known) {
          return BRep_Tool::Pnt(known).Distance(at) < same_share * work.diagonal;
        }))
      return;
    found.push_back(BRepBuilderAPI_MakeVertex(at));
    BRep_Builder().UpdateVertex(found.back(), gap + Precision::Confusion());
  };
  std::vector<std::vector<TopoDS_Face>> faces(work.parts.size());
  for (const WorkFace& face : work.faces)
    if (face.is_usable())
      for (const FaceUse& use : face.uses) faces[use.part].push_back(face.face);
  for (const PartPair& pair : pairs) {
    progress.check();
    for (const TopoDS_Face& one : faces[pair[0]])
      for (const TopoDS_Face& two : faces[pair[1]]) {
        if (!may_touch_in_points(one, two, tolerance)) continue;
        const BRepExtrema_DistShapeShape nearest(one, two);
        if (!nearest.IsDone() || nearest.Value() > tolerance || nearest.NbSolution() > most_points_of_pair) continue;
        for (int i = 1; i <= nearest.NbSolution(); ++i) {
          const gp_Pnt here = nearest.PointOnShape1(i), there = nearest.PointOnShape2(i);
          add(0.5 * (here.XYZ() + there.XYZ()), nearest.Value());
        }
      }
  }
  return found;
}

}  // namespace paver
