// Faces that were drawn twice, one on the other: the later one is left out, before anything is sewn to it. Only within
// one solid, and among faces without one; what different parts have in common is connected instead. Both go where they
// are sides of a slit without width in a solid. About a plate or a void as thin as that walls go, too.
#include <BOPTools_AlgoTools.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Compound.hxx>
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

using Doubles = std::vector<std::array<int, 2>>;  // each face with the first one on which it lies

/// What tells most faces apart at no cost.
struct Outline {
  int index = -1;
  Box box;  ///< of the ends and middles of its edges
};

class DoubleFinder {
 public:
  DoubleFinder(const Workpiece& work, const std::function<bool(const WorkFace&, const WorkFace&)>& may_be_one)
      : work_(work), may_be_one_(may_be_one), tolerance_(doubled_share * work.diagonal) {}

  Doubles run() {
    Doubles doubles;
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

/// Sets of faces that share edges.
UnionFind find_skins(const Workpiece& work, const EdgeUses& uses) {
  UnionFind together(work.faces.size());
  std::vector<int> first_face(uses.count.Extent() + 1, -1);
  for (int f = 0; f < static_cast<int>(work.faces.size()); ++f) {
    if (!work.faces[f].has_area) continue;
    for (const TopoDS_Edge& edge : edges_of(work.faces[f].face))
      if (int& known = first_face[uses.count.FindIndex(edge)]; known < 0) {
        known = f;
      } else {
        together.merge(f, known);
      }
  }
  return together;
}

/// Tells sides of a slit in a solid from what was drawn twice.
class Slits {
 public:
  Slits(const Workpiece& work, const Doubles& doubles)
      : work_(work),
        uses_(count_uses(work.faces)),
        together_(find_skins(work, uses_)),
        has_single_(work.faces.size(), 0) {
    std::vector<char> is_double(work.faces.size(), 0);
    for (const auto& [later, first] : doubles) is_double[later] = is_double[first] = 1;
    for (int f = 0; f < static_cast<int>(work.faces.size()); ++f)
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

/// Skins of nothing but faces drawn twice and walls between these that are no higher than doubles are apart.
class FlatSkins {
 public:
  FlatSkins(const Workpiece& work, const Doubles& doubles) : work_(work), partner_(work.faces.size(), -1) {
    for (const auto& [later, first] : doubles) partner_[later] = first, partner_[first] = later;
  }

  /// Faces that go: walls, and both sides of a void.
  std::vector<int> leaving() const {
    UnionFind together = find_skins(work_, count_uses(work_.faces));
    std::vector<std::vector<int>> skins(work_.faces.size());
    for (int f = 0; f < static_cast<int>(work_.faces.size()); ++f)
      if (work_.faces[f].has_area) skins[together.find(f)].push_back(f);
    std::vector<int> leaving;
    for (const std::vector<int>& skin : skins) {
      if (!is_flat(skin)) continue;
      const bool is_void = work_.faces[skin.front()].solid >= 0 && volume_of(skin) < 0;
      for (const int f : skin)
        if (partner_[f] < 0 || is_void) leaving.push_back(f);
    }
    return leaving;
  }

 private:
  bool is_flat(const std::vector<int>& skin) const {
    const auto walls = std::ranges::count_if(skin, [&](int f) { return partner_[f] < 0; });
    return walls > 0 && walls < std::ssize(skin) && std::ranges::all_of(skin, [&](int f) {
             return partner_[f] >= 0 ? std::ranges::binary_search(skin, partner_[f]) : is_wall(work_.faces[f]);
           });
  }

  bool is_wall(const WorkFace& face) const {
    double border = 0;
    for (const TopoDS_Edge& edge : edges_of(face.face)) border += edge_length(edge);
    return face.area <= doubled_share * work_.diagonal * 0.5 * border;
  }

  /// mm^3
  double volume_of(const std::vector<int>& skin) const {
    TopoDS_Compound faces;
    BRep_Builder builder;
    builder.MakeCompound(faces);
    for (const int f : skin) builder.Add(faces, work_.faces[f].face);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(faces, properties);
    return properties.Mass();
  }

  const Workpiece& work_;
  std::vector<int> partner_;  // per face: that on which it lies, -1: none
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
  const Doubles doubles = find_doubles(work, are_of_one);
  if (doubles.empty()) return;
  auto drop = [&](WorkFace& face) {
    face.is_dropped = true;
    face.lose_area();
    work.note_repair(RepairKind::dropped_face, 1, doubled_share * work.diagonal, face_name(face.origin));
  };
  for (const int face : FlatSkins(work, doubles).leaving()) drop(work.faces[face]);
  Slits slits(work, doubles);
  for (const std::array<int, 2>& pair : doubles) {
    WorkFace &later = work.faces[pair[0]], &first = work.faces[pair[1]];
    if (!later.has_area || !first.has_area) continue;
    if (slits.has(pair[0], pair[1])) drop(first);
    drop(later);
    work.doubles.push_back(pair);
  }
}

}  // namespace paver
