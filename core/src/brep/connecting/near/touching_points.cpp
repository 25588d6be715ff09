// Points in which faces of two parts touch: a ball on a plate, the end of a rod on a ball. The kernel finds those on
// edges and poles; inside both faces it depends on rounding whether they meet at all.
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRep_Builder.hxx>
#include <algorithm>

#include "brep/connecting/connect_impl.h"
#include "brep/connecting/near/face_cells_impl.h"

namespace paver {
namespace {

constexpr double same_share = 1e-4;     // of the diagonal: points nearer each other are one
constexpr int most_points_of_pair = 4;  // more are places of a line

/// A face as what tells whether it may touch others.
struct Candidate {
  TopoDS_Face face;
  PartPiece piece;
};

bool may_touch_in_points(Candidate& one, Candidate& two) {
  const bool are_free_form = one.piece.is_free_form() && two.piece.is_free_form();
  return !are_free_form && !one.piece.is_level_with(two.piece) && may_touch(one.piece, two.piece);
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
  std::vector<char> is_asked(work.parts.size(), 0);
  for (const PartPair& pair : pairs) is_asked[pair[0]] = is_asked[pair[1]] = 1;
  std::vector<std::vector<Candidate>> candidates(work.parts.size());
  for (const WorkFace& face : work.faces)
    for (const FaceUse& use : face.uses)
      if (face.is_usable() && is_asked[use.part])
        candidates[use.part].push_back({face.face, PartPiece(face.face, 0.5 * tolerance)});
  for (const PartPair& pair : pairs) {
    progress.check();
    for (Candidate& one : candidates[pair[0]])
      for (Candidate& two : candidates[pair[1]]) {
        if (!may_touch_in_points(one, two)) continue;
        const auto nearest = nearest_places(one.face, two.face);
        if (!nearest || nearest->Value() > tolerance || nearest->NbSolution() > most_points_of_pair) continue;
        for (int i = 1; i <= nearest->NbSolution(); ++i) {
          const gp_Pnt here = nearest->PointOnShape1(i), there = nearest->PointOnShape2(i);
          add(0.5 * (here.XYZ() + there.XYZ()), nearest->Value());
        }
      }
  }
  return found;
}

}  // namespace paver
