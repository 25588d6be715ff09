// Steps: pairs of elements that are near each other in cells of space where elements look different ways; a side of one
// that goes through the other.
#include "check/distance/crossings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "check/near/found_places.h"

namespace paver {
namespace {

constexpr double least_depth = 1e-5;          // of the longer element; what is nearer touches
constexpr double least_sine_squared = 0.067;  // of 15 degrees
constexpr int samples = 4;                    // of a side
constexpr double least_step = 1e-9;           // of a side
constexpr double on_patch = 1e-6;             // of the longer element: what is nearer lies on it
constexpr std::array<double, 6> component_weights{1, 1, 1, 2, 2, 2};

/// How far directions differ, whichever way they look: the range of the products of their components, of which two
/// directions differ by the square root of 2 times the sine between them.
struct Directions {
  std::array<double, 6> low, high;

  Directions() {
    low.fill(Box::infinity);
    high.fill(-Box::infinity);
  }
  void add(Vec3 n) {
    const std::array<double, 6> products{n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.y * n.z, n.z * n.x};
    add(products, products);
  }
  void add(const Directions& other) { add(other.low, other.high); }
  bool differ() const {
    double squares = 0;
    for (int k = 0; k < 6; ++k) squares += component_weights[k] * (high[k] - low[k]) * (high[k] - low[k]);
    return squares > 2 * least_sine_squared;
  }

 private:
  void add(const std::array<double, 6>& least, const std::array<double, 6>& most) {
    for (int k = 0; k < 6; ++k) low[k] = std::min(low[k], least[k]), high[k] = std::max(high[k], most[k]);
  }
};

/// At the corners, between the two sides there.
void add_normals(const ElementPatch& patch, Directions& directions) {
  const int n = patch.corners;
  for (int k = 0; k < n; ++k) {
    const Vec3 x = patch.nodes[k];
    const int before = (k + n - 1) % n;
    const Vec3 next = patch.nodes[patch.order > 1 ? n + k : (k + 1) % n];
    const Vec3 last = patch.nodes[patch.order > 1 ? n + before : before];
    const Vec3 normal = cross(next - x, last - x);
    if (const double length = norm(normal); length > 0) directions.add(1 / length * normal);
  }
}

/// A side as a line from its first corner.
ElementPatch side_of(const ElementPatch& patch, int k) {
  const int n = patch.corners;
  return {2, patch.order, {patch.nodes[k], patch.nodes[(k + 1) % n], patch.nodes[patch.order > 1 ? n + k : k]}};
}

/// Where a place is from a patch.
struct Offset {
  double distance = 0, height = 0;  ///< height: along the normal of the foot; less where that is on the border
  Vec2 foot;
};

Offset offset_from(const ElementPatch& patch, Vec3 x, Vec2 start) {
  Offset offset;
  offset.foot = patch.nearest(x, start);
  const auto [u, v] = patch.slopes(offset.foot);
  const Vec3 from = x - patch.at(offset.foot), normal = cross(u, v);
  offset.distance = norm(from);
  offset.height = dot(normal, normal) > 0 ? dot(from, normal) / norm(normal) : 0;
  return offset;
}

Vec2 middle_of(const ElementPatch& patch) { return patch.corners == 3 ? Vec2{1.0 / 3, 1.0 / 3} : Vec2{0.5, 0.5}; }

/// Where the line goes through the patch, by more than `depth` on either side.
std::optional<Vec3> piercing(const ElementPatch& line, const ElementPatch& patch, double depth, double near) {
  Offset last;  // that is farther than depth
  double low = 0;
  Vec2 start = middle_of(patch);
  for (int i = 0; i <= samples; ++i) {
    double high = 1.0 * i / samples;
    const Offset next = offset_from(patch, line.at({high, 0}), start);
    start = next.foot;
    if (std::abs(next.height) <= depth) continue;
    const Offset first = std::exchange(last, next);
    const double from = std::exchange(low, high);
    if (first.height * next.height >= 0) continue;
    Offset at = first;
    for (double least = from; at.distance > near && high - least > least_step;) {
      const double half = 0.5 * (least + high);
      at = offset_from(patch, line.at({half, 0}), at.foot);
      (at.height * first.height > 0 ? least : high) = half;
    }
    if (at.distance <= near) return patch.at(at.foot);
  }
  return std::nullopt;
}

double longest_side(const ElementPatch& patch) {
  double longest = 0;
  for (int k = 0; k < patch.corners; ++k)
    longest = std::max(longest, norm(patch.nodes[k] - patch.nodes[(k + 1) % patch.corners]));
  return longest;
}

bool are_aslant(Vec3 n, Vec3 m) { return dot(cross(n, m), cross(n, m)) > least_sine_squared * dot(n, n) * dot(m, m); }

/// A corner that lies on the patch, at an angle: where the line in which two meshes cross falls on nodes of both.
std::optional<Vec3> touching(const ElementPatch& one, const ElementPatch& patch, double near) {
  const Box box = patch.bounds();
  for (int k = 0; k < one.corners; ++k) {
    const Vec3 x = one.nodes[k];
    if (!box.meets(Box{x, x}.grown(near))) continue;
    const Offset offset = offset_from(patch, x, middle_of(patch));
    if (offset.distance > near) continue;
    const auto [u, v] = patch.slopes(offset.foot);
    if (are_aslant(cross(u, v), one.mean_normal())) return x;
  }
  return std::nullopt;
}

std::optional<Vec3> crossing(const ElementPatch& a, const ElementPatch& b) {
  const double longest = std::max(longest_side(a), longest_side(b)), depth = least_depth * longest;
  if (are_apart(a, b, depth)) return std::nullopt;
  const std::array<std::pair<const ElementPatch*, const ElementPatch*>, 2> both{{{&a, &b}, {&b, &a}}};
  for (const auto& [one, other] : both)
    for (int k = 0; k < one->corners; ++k) {
      const ElementPatch side = side_of(*one, k);
      if (!side.bounds().meets(other->bounds()) || are_apart(side, *other, depth)) continue;
      if (auto where = piercing(side, *other, depth, on_patch * longest)) return where;
    }
  for (const auto& [one, other] : both)
    if (auto where = touching(*one, *other, depth)) return where;
  return std::nullopt;
}

/// The first of two faces, however many of their elements run through each other; a face in pieces is one.
struct CrossingPlace {
  std::array<int, 2> pair{};  ///< origins of the faces
  std::array<int, 2> faces{};
  PairOrder order;
  Vec3 where;

  PairOrder key() const { return order; }
};
using FoundCrossings = FoundPlaces<CrossingPlace>;

class CrossingSearch {
 public:
  using Summary = Directions;

  CrossingSearch(const MeshPieces& all, const Model& model, const PartPairs& told) : model_(model), all_(all) {
    auto number = [&](const std::string& part) {
      return static_cast<int>(std::ranges::find(model.parts, part) - model.parts.begin());
    };
    for (const auto& [one, other] : told)
      told_.push_back({std::min(number(one), number(other)), std::max(number(one), number(other))});
  }

  bool is_wanted(std::size_t element) const { return element < all_.element_count(); }
  Box box(const Piece& piece) const { return piece.patch.bounds().grown(least_depth * longest_side(piece.patch)); }
  Directions summary(const Piece& piece) const {
    Directions own;
    add_normals(piece.patch, own);
    return own;
  }
  bool is_mixed(const Directions& directions) const { return directions.differ(); }

  void compare(FoundCrossings& found, const Piece& a, const Piece& b, const PairOrder& order) const {
    auto origin = [&](const Piece& piece) { return model_.faces[piece.face].origin; };
    if (origin(b) < origin(a)) return compare(found, b, a, order);
    const Pair origins{origin(a), origin(b)};
    if (found.of(origins) || is_told(a.face, b.face) || have_common_corner(a, b)) return;
    if (const auto where = crossing(a.patch, b.patch)) found.add({origins, {a.face, b.face}, order, *where});
  }

 private:
  using Pair = FoundCrossings::Pair;

  bool is_told(int face, int other) const {
    for (int p : model_.face_parts[face])
      for (int q : model_.face_parts[other])
        if (std::ranges::find(told_, Pair{std::min(p, q), std::max(p, q)}) != told_.end()) return true;
    return false;
  }

  // Nodes at one place are one but where they lie on different edges, or inside different faces that merging left
  // alone, as where two meshes cross in nodes of both.
  bool have_common_corner(const Piece& a, const Piece& b) const {
    auto is_whole = [&](int face) { return model_.faces[face].merged_area == 0; };
    auto is_point = [&](Vec3 x) {
      return std::ranges::any_of(model_.faces[a.face].points,
                                 [&](const InnerPoint& point) { return model_.vertices[point.vertex] == x; });
    };
    const bool are_divided = a.face != b.face && is_whole(a.face) && is_whole(b.face);
    for (int i = 0; i < a.patch.corners; ++i)
      for (int j = 0; j < b.patch.corners; ++j) {
        if (a.patch.nodes[i] != b.patch.nodes[j] || a.node_edge[i] != b.node_edge[j]) continue;
        if (a.node_edge[i] >= 0 || !are_divided || is_point(a.patch.nodes[i])) return true;
      }
    return false;
  }

  const Model& model_;
  const MeshPieces& all_;
  std::vector<Pair> told_;  // parts, the lower first
};

}  // namespace

std::vector<Crossing> find_crossings(const MeshPieces& pieces, const Model& model, const PartPairs& told,
                                     Ranks& ranks) {
  std::vector<Crossing> crossings;
  for (const auto& place : find_places<CrossingPlace>(CrossingSearch(pieces, model, told), pieces, ranks))
    crossings.push_back({{model.faces[place.faces[0]].name, model.faces[place.faces[1]].name}, place.where});
  return crossings;
}

}  // namespace paver
