// Faces that were drawn twice, one on the other: the later one is left out, before anything is sewn to it. Only within
// one solid, and among faces without one; what different parts have in common is connected instead. Both go where they
// are sides of a slit without width in a solid.
#include <BOPTools_AlgoTools.hxx>
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

/// Tells sides of a slit in a solid from what was drawn twice.
class Slits {
 public:
  Slits(const Workpiece& work, const std::vector<std::array<int, 2>>& doubles)
      : work_(work), uses_(count_uses(work.faces)), together_(work.faces.size()), has_single_(work.faces.size(), 0) {
    std::vector<char> is_double(work.faces.size(), 0);
    for (const auto& [later, first] : doubles) is_double[later] = is_double[first] = 1;
    std::vector<int> first_face(uses_.count.Extent() + 1, -1);
    const int count = static_cast<int>(work.faces.size());
    for (int f = 0; f < count; ++f) {
      if (!work.faces[f].has_area) continue;
      for (const TopoDS_Edge& edge : edges_of(work.faces[f].face))
        if (int& known = first_face[uses_.count.FindIndex(edge)]; known < 0) {
          known = f;
        } else {
          together_.merge(f, known);
        }
    }
    for (int f = 0; f < count; ++f)
      if (!is_double[f]) has_single_[together_.find(f)] = 1;
  }

  /// Whether the two look at each other, in skins that have more faces, and what stays at their edges can be closed.
  bool has(int one, int two) {
    const TopoDS_Face &face = work_.faces[one].face, &other = work_.faces[two].face;
    if (work_.faces[one].solid < 0 || !has_single_[together_.find(one)] || !has_single_[together_.find(two)] ||
        !BOPTools_AlgoTools::IsSplitToReverse(face, other, context_))
      return false;
    const auto edges = shapes_of(face, TopAbs_EDGE), others = shapes_of(other, TopAbs_EDGE);
    auto stays_open = [&](const TopoDS_Shape& edge) {
      const int own = edges.Contains(edge) + others.Contains(edge);
      return !BRep_Tool::Degenerated(TopoDS::Edge(edge)) && uses_.count.FindFromKey(edge) == own + own - 1;
    };
    return std::none_of(edges.cbegin(), edges.cend(), stays_open) &&
           std::none_of(others.cbegin(), others.cend(), stays_open);
  }

 private:
  const Workpiece& work_;
  EdgeUses uses_;
  UnionFind together_;            // faces that share edges
  std::vector<char> has_single_;  // per set of these, at its root: a face that was drawn once
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
  const std::vector<std::array<int, 2>> doubles = find_doubles(work, are_of_one);
  if (doubles.empty()) return;
  Slits slits(work, doubles);
  auto drop = [&](WorkFace& face) {
    face.is_dropped = true;
    face.lose_area();
    work.note_repair(RepairKind::dropped_face, 1, doubled_share * work.diagonal, face_name(face.origin));
  };
  for (const std::array<int, 2>& pair : doubles) {
    WorkFace &later = work.faces[pair[0]], &first = work.faces[pair[1]];
    if (!later.has_area || !first.has_area) continue;
    if (slits.has(pair[0], pair[1])) drop(first);
    drop(later);
    work.doubles.push_back(pair);
  }
}

}  // namespace paver
