// Which faces lie inside solids that they do not bound: a point of the face, by the number of times that rays from it
// leave the solid.
//
// The kernel's own classifier looks along one line, and takes points below a lofted wing, outside of its box even, for
// inside where it misses a face. So several directions are asked.
#include <BOPTools_AlgoTools3D.hxx>
#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <IntTools_Context.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <array>
#include <gp_Lin.hxx>
#include <memory>
#include <optional>

#include "brep/connecting/connect_impl.h"

namespace paver {
namespace {

class InsideClassifier {
 public:
  explicit InsideClassifier(const TopoDS_Shape& solid) { rays_.Load(solid, Precision::Confusion()); }

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

class InsideFinder {
 public:
  explicit InsideFinder(Workpiece& work) : work_(work) {}

  void run() {
    for (std::size_t p = 0; p < work_.parts.size(); ++p)
      if (work_.parts[p].solid >= 0) look_inside(static_cast<int>(p));
  }

 private:
  void look_inside(int part) {
    const TopoDS_Shape solid = solids()(work_.parts[static_cast<std::size_t>(part)].solid + 1);
    if (boxes_.empty()) measure_faces();
    Bnd_Box box;
    BRepBndLib::Add(solid, box, Standard_False);
    std::unique_ptr<InsideClassifier> classifier;
    for (std::size_t f = 0; f < work_.faces.size(); ++f) {
      WorkFace& face = work_.faces[f];
      if (!face.is_usable() || face.has_part(part) || box.IsOut(boxes_[f])) continue;
      gp_Pnt point;
      gp_Pnt2d uv;
      if (BOPTools_AlgoTools3D::PointInFace(face.face, point, uv, context_) != 0 || box.IsOut(point)) continue;
      if (!classifier) classifier = std::make_unique<InsideClassifier>(solid);
      if (classifier->holds(point)) face.inside_of.push_back(part);
    }
  }

  void measure_faces() {
    for (const WorkFace& face : work_.faces) {
      boxes_.emplace_back();
      if (face.is_usable()) BRepBndLib::Add(face.face, boxes_.back(), Standard_False);
    }
  }

  const TopTools_IndexedMapOfShape& solids() {
    if (solids_.IsEmpty()) TopExp::MapShapes(work_.shape, TopAbs_SOLID, solids_);
    return solids_;
  }

  Workpiece& work_;
  std::vector<Bnd_Box> boxes_;  ///< per face
  TopTools_IndexedMapOfShape solids_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace

void find_insides(Workpiece& work) { InsideFinder(work).run(); }

}  // namespace paver
