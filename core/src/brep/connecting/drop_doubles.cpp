// Faces that were drawn twice, one on the other: the later one is left out, before anything is sewn to it. Only within
// one solid, and among faces without one; what different parts have in common is connected instead.
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/box.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

/// Faces this near each other, of the diagonal, are one; two sheets 5e-6 of it apart are drawn so.
constexpr double same_share = 1e-7;
constexpr double same_area_share = 1e-6;
constexpr int edge_samples = 6;

/// What tells most faces apart at no cost.
struct Outline {
  int index = -1;
  Box box;  ///< of the ends and middles of its edges
};

class DoubleFinder {
 public:
  explicit DoubleFinder(Workpiece& work) : work_(work), tolerance_(same_share * work.diagonal) {}

  void run() {
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < work_.faces.size(); ++i)
      if (work_.faces[i].is_usable()) outlines.push_back(outline(static_cast<int>(i)));
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const Outline& a, const Outline& b) { return a.box.low.x < b.box.low.x; });
    for (std::size_t i = 0; i < outlines.size(); ++i)
      for (std::size_t j = i + 1; j < outlines.size() && outlines[j].box.low.x - outlines[i].box.low.x <= tolerance_;
           ++j)
        compare(outlines[i], outlines[j]);
  }

 private:
  WorkFace& face(int index) { return work_.faces[index]; }

  Outline outline(int index) {
    constexpr double far = 1e300;  // finite: faces without such points are compared as well
    Outline made{index, {{far, far, far}, {-far, -far, -far}}};
    for (const TopoDS_Edge& edge : edges_of(face(index).face))
      for (double share : {0.0, 0.5, 1.0})
        if (const auto x = point_of(edge, share)) made.box.add(*x);
    return made;
  }

  static std::optional<Vec3> point_of(const TopoDS_Edge& edge, double share) {
    const CurveRange range = range_of(edge);
    const auto curve = BRep_Tool::Degenerated(edge) ? nullptr : make_curve(edge);
    return curve && range.is_finite() ? std::optional(curve->point(range.at(share))) : std::nullopt;
  }

  void compare(const Outline& a, const Outline& b) {
    const WorkFace &one = face(std::min(a.index, b.index)), &two = face(std::max(a.index, b.index));
    if (!one.has_area || !two.has_area || one.solid != two.solid) return;
    if (std::abs(one.area - two.area) > same_area_share * one.area) return;
    if (norm(a.box.low - b.box.low) > tolerance_ || norm(a.box.high - b.box.high) > tolerance_) return;
    if (!lies_on(two.face, one.face) || !lies_on(one.face, two.face)) return;
    WorkFace& dropped = face(std::max(a.index, b.index));
    dropped.is_dropped = true;
    dropped.lose_area();
    work_.note_repair(RepairKind::dropped_face, 1, tolerance_, face_name(dropped.origin));
    work_.doubles.push_back({std::max(a.index, b.index), std::min(a.index, b.index)});
  }

  bool lies_on(const TopoDS_Face& face, const TopoDS_Face& other) {
    const auto inside = point_inside(face, context_);
    if (!inside || !is_near(*inside, other, tolerance_)) return false;
    for (const TopoDS_Edge& edge : edges_of(face))
      for (int i = 0; i < edge_samples; ++i) {
        const auto x = point_of(edge, (i + 0.5) / edge_samples);
        if (x && !is_near(to_point(*x), other, tolerance_)) return false;
      }
    return true;
  }

  Workpiece& work_;
  double tolerance_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace

void drop_doubles(Workpiece& work) {
  try {
    DoubleFinder(work).run();
  } catch (const Standard_Failure&) {
    // Faces that the kernel cannot compare stay.
  }
}

}  // namespace paver
