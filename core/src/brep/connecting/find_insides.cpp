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
  explicit InsideClassifier(const TopoDS_Shape& solid) {
    BRep_Builder builder;
    TopoDS_Compound boundary;
    builder.MakeCompound(boundary);
    for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
      if (is_bounding(face.Current())) builder.Add(boundary, face.Current());
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

Bnd_Box box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box;
}

Box to_box(const Bnd_Box& box) {
  if (box.IsVoid()) return {{}, {}};
  return {to_vec(box.CornerMin()), to_vec(box.CornerMax())};
}

}  // namespace

gp_Pnt middle_of(const TopoDS_Edge& edge) {
  const CurveRange range = range_of(edge);
  return BRepAdaptor_Curve(edge).Value(range.at(0.5));
}

void find_insides(Workpiece& work) {
  if (std::none_of(work.parts.begin(), work.parts.end(), [](const auto& part) { return part.solid >= 0; })) return;
  const auto solids = shapes_of(work.shape, TopAbs_SOLID);
  std::vector<Box> boxes;
  for (const WorkFace& face : work.faces) boxes.push_back(to_box(face.is_usable() ? box_of(face.face) : Bnd_Box()));
  const BoxTree tree(std::move(boxes));
  PointsInside points;
  for (std::size_t part = 0; part < work.parts.size(); ++part) {
    if (work.parts[part].solid < 0) continue;
    const TopoDS_Shape solid = solids(work.parts[part].solid + 1);
    const Bnd_Box box = box_of(solid);
    std::unique_ptr<InsideClassifier> classifier;
    auto holds = [&](const gp_Pnt& point) {
      if (box.IsOut(point)) return false;
      if (!classifier) classifier = std::make_unique<InsideClassifier>(solid);
      return classifier->holds(point);
    };
    tree.each_meeting(to_box(box), [&](int f) {
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
