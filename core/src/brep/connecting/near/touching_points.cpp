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
  auto add = [&](const gp_Pnt& at, double gap) {
    if (std::ranges::any_of(found, [&](const TopoDS_Vertex& known) {
          return BRep_Tool::Pnt(known).Distance(at) < same_share * work.diagonal;
        }))
      return;
    found.push_back(BRepBuilderAPI_MakeVertex(at));
    BRep_Builder().UpdateVertex(found.back(), gap + Precision::Confusion());
  };
  auto has = [&](const WorkFace& face, int part) { return face.is_usable() && face.has_part(part); };
  for (const PartPair& pair : pairs) {
    progress.check();
    for (const WorkFace& one : work.faces) {
      if (!has(one, pair[0])) continue;
      for (const WorkFace& two : work.faces) {
        if (!has(two, pair[1]) || !may_touch_in_points(one.face, two.face, tolerance)) continue;
        const BRepExtrema_DistShapeShape nearest(one.face, two.face);
        if (!nearest.IsDone() || nearest.Value() > tolerance || nearest.NbSolution() > most_points_of_pair) continue;
        for (int i = 1; i <= nearest.NbSolution(); ++i) {
          const gp_Pnt here = nearest.PointOnShape1(i), there = nearest.PointOnShape2(i);
          add(0.5 * (here.XYZ() + there.XYZ()), nearest.Value());
        }
      }
    }
  }
  return found;
}

}  // namespace paver
