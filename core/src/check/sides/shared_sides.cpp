// Each rank answers for the sides and elements whose lowest node leaves its own rank over.
// Steps: what the loops of the faces ask for; side by side, what each face does with it; then all faces together.
#include <algorithm>
#include <span>
#include <tuple>

#include "base/tasks/gather.h"
#include "check/sides/sides_impl.h"

namespace paver {
namespace {

/// What a face's loop asks of its elements: one side like this.
struct WantedSide {
  SharedSide side;
  int edge = -1;
};

auto key(const SharedSide& side) { return std::tie(side.low, side.high, side.face, side.direction, side.middle); }

/// Edges that only one face has, twice, need not be followed by its elements.
bool is_wanted(const Edge& edge) {
  const std::vector<int>& faces = edge.faces;
  const bool is_of_one = std::all_of(faces.begin(), faces.end(), [&](int face) { return face == faces.front(); });
  return faces.size() == 1 || !is_of_one;
}

/// The edges' intervals as the loop of a meshed face runs along them.
void add_wanted(const CheckedMesh& checked, const Ranks& ranks, int face, const Coedge& coedge,
                std::vector<WantedSide>& wanted) {
  const SurfaceMesh& mesh = checked.mesh;
  const bool is_backward = coedge.is_reversed != checked.model.faces[face].is_reversed;
  auto [first, last] = std::equal_range(mesh.line_edge.begin(), mesh.line_edge.end(), coedge.edge);
  for (auto line = first; line != last; ++line) {
    const auto v = mesh.line(static_cast<std::size_t>(line - mesh.line_edge.begin()));
    const long from = checked.number(v[is_backward ? 1 : 0]), to = checked.number(v[is_backward ? 0 : 1]);
    if (std::min(from, to) % ranks.count() != ranks.rank()) continue;
    const long middle = mesh.order == 1 ? -1 : checked.number(v[2]);
    wanted.push_back(
        {{std::min(from, to), std::max(from, to), middle, face, from < to ? 1 : -1, checked.middle(v[0], v[1])},
         coedge.edge});
  }
}

std::vector<WantedSide> wanted_sides(const CheckedMesh& checked, const Ranks& ranks) {
  std::vector<WantedSide> wanted;
  for (std::size_t f = 0; f < checked.model.faces.size(); ++f) {
    if (!checked.is_meshed[f]) continue;
    for (const Coedge& coedge : coedges_of(checked.model.faces[f].loops))
      if (is_wanted(checked.model.edges[coedge.edge])) add_wanted(checked, ranks, static_cast<int>(f), coedge, wanted);
  }
  std::ranges::sort(wanted, {}, [](const WantedSide& one) { return key(one.side); });
  return wanted;
}

/// visit(there, wanted) for those of either that have a key in common, by rising keys. Both are in this order.
template <class Key, class Visit>
void for_groups(std::span<const SharedSide> there, std::span<const WantedSide> wanted, Key key, Visit visit) {
  while (!there.empty() || !wanted.empty()) {
    const auto first = there.empty()    ? key(wanted[0].side)
                       : wanted.empty() ? key(there[0])
                                        : std::min(key(there[0]), key(wanted[0].side));
    std::size_t t = 0, w = 0;
    while (t < there.size() && key(there[t]) == first) ++t;
    while (w < wanted.size() && key(wanted[w].side) == first) ++w;
    visit(there.first(t), wanted.first(w));
    there = there.subspan(t), wanted = wanted.subspan(w);
  }
}

/// Sides between the same two nodes: what is there and what is asked for, both in order.
class SideGroup {
 public:
  SideGroup(const CheckedMesh& checked, std::span<const SharedSide> there, std::span<const WantedSide> wanted,
            MeshFaults& faults)
      : checked_(checked), there_(there), wanted_(wanted), faults_(faults) {}

  void check() {
    auto face = [](const SharedSide& side) { return side.face; };
    for_groups(there_, wanted_, face, [&](auto there, auto wanted) { check_face(there, wanted); });
    check_faces();
    check_overlaps();
  }

 private:
  struct User {
    int face;
    long uses;
    bool is_at_boundary;
  };

  void check_face(std::span<const SharedSide> there, std::span<const WantedSide> wanted) {
    const int face = there.empty() ? wanted[0].side.face : there[0].face;
    users_.push_back({face, static_cast<long>(there.size()), !wanted.empty()});
    if (wanted.empty()) {
      const bool is_pair =
          there.size() == 2 && there[0].direction != there[1].direction && there[0].middle == there[1].middle;
      if (!is_pair) faults_.add(face, FaultKind::side, there[0].where);
      return;
    }
    const bool is_as_wanted =
        std::equal(there.begin(), there.end(), wanted.begin(), wanted.end(),
                   [](const SharedSide& a, const WantedSide& b) { return key(a) == key(b.side); });
    if (!is_as_wanted) faults_.add(face, FaultKind::boundary, wanted[0].side.where);
  }

  // Too many elements: first those of faces that have no business there, then of those that have most.
  void check_faces() {
    long allowed = 2, uses = 0;
    if (!wanted_.empty()) allowed = 1;
    for (const WantedSide& side : wanted_)
      allowed = std::max(allowed, static_cast<long>(checked_.model.edges[side.edge].faces.size()));
    for (const User& user : users_) uses += user.uses;
    if (uses <= allowed) return;
    std::sort(users_.begin(), users_.end(), [](const User& a, const User& b) {
      return std::tuple(a.is_at_boundary, -a.uses, -a.face) < std::tuple(b.is_at_boundary, -b.uses, -b.face);
    });
    for (const User& user : users_) {
      if (uses <= allowed) break;
      faults_.add(user.face, FaultKind::shared, there_[0].where);
      uses -= user.uses;
    }
  }

  // Elements of two faces that leave the side alike lie on each other: the first face's stay. Where a cylinder touches
  // a plane they leave it in one direction, but bend apart.
  void check_overlaps() {
    constexpr double same = 1e-6, same_bend = 1e-4;  // radians; of the side's length
    for (std::size_t i = 0; i < there_.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        const Heading &a = there_[k].heading, &b = there_[i].heading;
        if (there_[k].face == there_[i].face || a.inward == Vec3{} || b.inward == Vec3{}) continue;
        // Bends are counted from either side.
        const double turned = there_[k].direction == there_[i].direction ? b.bend : -b.bend;
        if (norm(a.inward - b.inward) < same && std::abs(a.bend - turned) < same_bend)
          faults_.add(there_[i].face, FaultKind::overlap, there_[i].where);
      }
  }

  const CheckedMesh& checked_;
  std::span<const SharedSide> there_;
  std::span<const WantedSide> wanted_;
  MeshFaults& faults_;
  std::vector<User> users_;
};

void check_sides(const CheckedMesh& checked, std::span<const SharedSide> there, std::span<const WantedSide> wanted,
                 MeshFaults& faults) {
  auto ends = [](const SharedSide& side) { return std::pair(side.low, side.high); };
  for_groups(there, wanted, ends, [&](auto some, auto asked) { SideGroup(checked, some, asked, faults).check(); });
}

// Of elements with the same corners the first face's stay.
void check_elements(std::vector<SharedElement> elements, MeshFaults& faults) {
  std::ranges::sort(elements, {}, [](const SharedElement& e) {
    return std::tie(e.corners, e.face, e.where.x, e.where.y, e.where.z);
  });
  for (std::size_t i = 1; i < elements.size(); ++i) {
    if (elements[i].corners != elements[i - 1].corners) continue;
    faults.add(elements[i].face, FaultKind::same_element, elements[i].where);
  }
}

}  // namespace

void check_shared(const CheckedMesh& checked, const SharedLists& mine, Ranks& ranks, MeshFaults& faults) {
  std::vector<SharedSide> sides = deal(mine.sides, ranks, [](const SharedSide& side) { return side.low; });
  std::ranges::sort(sides, {}, [](const SharedSide& side) { return key(side); });
  check_sides(checked, sides, wanted_sides(checked, ranks), faults);
  auto lowest = [](const SharedElement& element) { return std::max(element.corners[0], element.corners[1]); };
  check_elements(deal(mine.elements, ranks, lowest), faults);
}

}  // namespace paver
