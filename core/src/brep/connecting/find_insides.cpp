// Which faces and wires lie inside solids that they do not bound: a point of them, by the number of times that rays
// from it leave the solid.
//
// The kernel's own classifier looks along one line, and takes points below a lofted wing, outside of its box even, for
// inside where it misses a face. So several directions are asked.
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <array>
#include <gp_Lin.hxx>
#include <memory>
#include <optional>

#include "base/boxes/box_tree.h"
#include "brep/connecting/connect_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"

namespace paver {
namespace {

class InsideClassifier {
 public:
  /// By the faces as they were mended: those as read may have lost images to that, at which the kernel breaks down.
  InsideClassifier(const Workpiece& work, const std::vector<int>& faces) {
    BRep_Builder builder;
    TopoDS_Compound boundary;
    builder.MakeCompound(boundary);
    for (const int f : faces)
      if (work.faces[f].is_usable()) builder.Add(boundary, work.faces[f].face);
    rays_.Load(boundary, Precision::Confusion());
  }

  /// Points on the boundary are not inside.
  bool holds(const gp_Pnt& point) {
    // Along no axis, plane or diagonal that parts are usually drawn along.
    static const std::array<gp_Dir, 7> directions{
        gp_Dir(0.31, 0.53, 0.79),  gp_Dir(-0.73, 0.23, 0.61),  gp_Dir(0.19, -0.77, -0.41), gp_Dir(-0.47, -0.57, 0.37),
        gp_Dir(0.83, -0.29, 0.17), gp_Dir(-0.13, 0.71, -0.67), gp_Dir(0.59, 0.43, -0.89)};
    constexpr int enough = 3;  // as long as they agree
    int inside = 0, outside = 0;
    for (const gp_Dir& direction : directions) {
      const std::optional<bool> is_odd = crosses_oddly(gp_Lin(point, direction));
      if (!is_odd) continue;
      ++(*is_odd ? inside : outside);
      if (std::abs(inside - outside) >= enough) break;
    }
    return inside > outside;
  }

 private:
  /// Nothing where the ray meets an edge, or the boundary where it starts.
  std::optional<bool> crosses_oddly(const gp_Lin& ray) {
    rays_.Perform(ray, -Precision::Confusion(), RealLast());
    if (!rays_.IsDone()) return std::nullopt;
    for (int i = 1; i <= rays_.NbPnt(); ++i)
      if (rays_.State(i) == TopAbs_ON || rays_.WParameter(i) <= Precision::Confusion()) return std::nullopt;
    return rays_.NbPnt() % 2 == 1;
  }

  IntCurvesFace_ShapeIntersector rays_;
};

/// One inside of each face, found once.
class PointsInside {
 public:
  const std::optional<gp_Pnt>& of(const TopoDS_Face& face) {
    if (const auto* known = known_.Seek(face)) return *known;
    return known_.ChangeFromIndex(known_.Add(face, point_inside(face, context_)));
  }

 private:
  NCollection_IndexedDataMap<TopoDS_Shape, std::optional<gp_Pnt>, TopTools_ShapeMapHasher> known_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

/// Empty where it has no place.
Box box_of(const TopoDS_Face& face) {
  Bnd_Box box;
  BRepBndLib::Add(face, box, Standard_False);
  return box.IsVoid() ? Box() : Box{to_vec(box.CornerMin()), to_vec(box.CornerMax())};
}

}  // namespace

gp_Pnt middle_of(const TopoDS_Edge& edge) {
  const CurveRange range = range_of(edge);
  return BRepAdaptor_Curve(edge).Value(range.at(0.5));
}

void find_insides(Workpiece& work) {
  if (std::none_of(work.parts.begin(), work.parts.end(), [](const auto& part) { return part.solid >= 0; })) return;
  std::vector<Box> boxes, boxes_of_parts(work.parts.size());
  std::vector<std::vector<int>> faces_of_parts(work.parts.size());
  for (std::size_t f = 0; f < work.faces.size(); ++f) {
    boxes.push_back(box_of(work.faces[f].face));
    for (const FaceUse& use : work.faces[f].uses) {
      boxes_of_parts[use.part].add(boxes.back());
      std::vector<int>& faces = faces_of_parts[use.part];
      if (faces.empty() || faces.back() != static_cast<int>(f)) faces.push_back(static_cast<int>(f));
    }
  }
  const BoxTree tree(std::move(boxes));
  PointsInside points;
  for (std::size_t part = 0; part < work.parts.size(); ++part) {
    if (work.parts[part].solid < 0) continue;
    const Box& box = boxes_of_parts[part];
    std::unique_ptr<InsideClassifier> classifier;
    auto holds = [&](const gp_Pnt& point) {
      const Vec3 x = to_vec(point);
      if (!box.meets({x, x})) return false;
      if (!classifier) classifier = std::make_unique<InsideClassifier>(work, faces_of_parts[part]);
      return classifier->holds(point);
    };
    tree.each_meeting(box, [&](int f) {
      WorkFace& face = work.faces[f];
      if (!face.is_usable() || face.has_part(static_cast<int>(part))) return;
      const std::optional<gp_Pnt>& point = points.of(face.face);
      if (point && holds(*point)) face.inside_of.push_back(static_cast<int>(part));
    });
    for (WorkWire& wire : work.wires)
      if (holds(middle_of(wire.edge))) wire.inside_of.push_back(static_cast<int>(part));
  }
}

}  // namespace paver
