// Faces that were drawn twice, one on the other: the later one is left out, before anything is sewn to it. Only within
// one solid, and among faces without one; what different parts have in common is connected instead.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "base/box.h"
#include "brep/mending/mend_impl.h"
#include "brep/occt_impl.h"
#include "brep/occt_shapes_impl.h"
#include "brep/surfaces/evaluators_impl.h"

namespace paver {
namespace {

constexpr int edge_samples = 6;

/// What tells most faces apart at no cost.
struct Outline {
  int index = -1;
  Box box;  ///< of the ends and middles of its edges
};

class DoubleFinder {
 public:
  DoubleFinder(const Workpiece& work, const std::function<bool(const WorkFace&, const WorkFace&)>& may_be_one)
      : work_(work), may_be_one_(may_be_one), tolerance_(doubled_share * work.diagonal) {}

  std::vector<std::array<int, 2>> run() {
    std::vector<std::array<int, 2>> doubles;
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < work_.faces.size(); ++i)
      if (work_.faces[i].is_usable()) outlines.push_back(outline(static_cast<int>(i)));
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const Outline& a, const Outline& b) { return a.box.low.x < b.box.low.x; });
    for (std::size_t i = 0; i < outlines.size(); ++i)
      for (std::size_t j = i + 1; j < outlines.size() && outlines[j].box.low.x - outlines[i].box.low.x <= tolerance_;
           ++j)
        if (are_one(outlines[i], outlines[j])) {
          const auto [first, later] = std::minmax(outlines[i].index, outlines[j].index);
          doubles.push_back({later, first});
        }
    return doubles;
  }

 private:
  const WorkFace& face(int index) const { return work_.faces[index]; }

  Outline outline(int index) const {
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

  bool are_one(const Outline& a, const Outline& b) {
    const WorkFace &one = face(std::min(a.index, b.index)), &two = face(std::max(a.index, b.index));
    if (norm(a.box.low - b.box.low) > tolerance_ || norm(a.box.high - b.box.high) > tolerance_) return false;
    if (!may_be_one_(one, two) || std::abs(one.area - two.area) > doubled_area_share * one.area) return false;
    return lies_on(two.face, one.face) && lies_on(one.face, two.face);
  }

  bool lies_on(const TopoDS_Face& face, const TopoDS_Face& other) {
    const auto inside = point_inside(face, context_);
    if (!inside || !is_near(*inside, other, tolerance_)) return false;
    for (const TopoDS_Edge& edge : edges_of(face))
      for (int i = 0; i < edge_samples; ++i) {
        const auto x = point_of(edge, (i + 0.5) / edge_samples);
        if (x && !is_near(to_point(*x), other, std::max(tolerance_, BRep_Tool::Tolerance(edge)))) return false;
      }
    return true;
  }

  const Workpiece& work_;
  const std::function<bool(const WorkFace&, const WorkFace&)>& may_be_one_;
  double tolerance_;
  Handle(IntTools_Context) context_ = new IntTools_Context;
};

}  // namespace

std::vector<std::array<int, 2>> find_doubles(const Workpiece& work,
                                             const std::function<bool(const WorkFace&, const WorkFace&)>& may_be_one) {
  try {
    return DoubleFinder(work, may_be_one).run();
  } catch (const Standard_Failure&) {
    return {};  // faces that the kernel cannot compare stay
  }
}

void drop_doubles(Workpiece& work) {
  auto are_of_one = [](const WorkFace& one, const WorkFace& two) { return one.solid == two.solid; };
  for (const std::array<int, 2>& pair : find_doubles(work, are_of_one)) {
    WorkFace& dropped = work.faces[pair[0]];
    if (!dropped.has_area || !work.faces[pair[1]].has_area) continue;
    dropped.is_dropped = true;
    dropped.lose_area();
    work.note_repair(RepairKind::dropped_face, 1, doubled_share * work.diagonal, face_name(dropped.origin));
    work.doubles.push_back(pair);
  }
}

}  // namespace paver
