#include "repair/curved_element.h"

#include <algorithm>

#include "check/area_slack.h"
#include "check/checked_mesh.h"
#include "check/direction.h"
#include "check/distance/deviation.h"
#include "check/vector_area.h"
#include "curving/near_surface.h"
#include "quality/jacobian/jacobian.h"

namespace paver {
namespace {

constexpr double folded = -0.5;     // value of an element that faces away or has a node twice
constexpr double steep = 0.7;       // cosine between its normal and the surface's at a corner: may miss the surface
constexpr double cusp_sine = 0.05;  // between two edges
constexpr double far = 0.25;        // of the distance that may be: from there on an element is poor

const JacobianForm& form_of(int corners, int order) {
  return jacobian_form(corners == 4 ? ElementShape::quad : ElementShape::triangle, order);
}

/// Of the sides of a quad of order 2.
Vec3 blend_of(const std::array<Vec3, 9>& x) {
  Vec3 blend;
  for (int k = 0; k < 4; ++k) blend += 0.5 * x[4 + k] - 0.25 * x[k];
  return blend;
}

}  // namespace

std::set<int> bounding_edges(std::span<const Region> regions) {
  std::set<int> edges;
  for (const Region& region : regions)
    for (const auto& loop : region.loops)
      for (const LoopNode& node : loop)
        if (node.edge >= 0) edges.insert(node.edge);
  return edges;
}

BoundarySides::BoundarySides(const Region& region, const EdgeNodes& edges) {
  for (int edge : bounding_edges({&region, 1})) {
    const EdgeDivision& division = edges.edges[edge];
    for (int i = 0; i < division.intervals(); ++i) {
      const int a = division.node[i], b = division.node[i + 1];
      const Vec3* x = &division.x[2 * static_cast<std::size_t>(i)];
      if (sides_.try_emplace(std::minmax(a, b), BoundarySide{edge, x[1]}).second) bulges_.add(a, x[0], b, x[2], x[1]);
    }
  }
}

const BoundarySide* BoundarySides::find(int a, int b) const {
  if (a < 0 || b < 0) return nullptr;
  const auto at = sides_.find(std::minmax(a, b));
  return at == sides_.end() ? nullptr : &at->second;
}

bool ElementJudge::has_forbidden_side(const Corners& v, int n) const {
  for (int k = 0; k < n; ++k)
    if (std::find(forbidden_.begin(), forbidden_.end(), std::pair<int, int>(std::minmax(v[k], v[(k + 1) % n]))) !=
        forbidden_.end())
      return true;
  return false;
}

std::array<Vec2, 4> ElementJudge::places(const Corners& v, int n) const {
  std::array<Vec2, 4> places;
  for (int k = 0; k < n; ++k) places[k] = mesh_.p[v[k]];
  return places;
}

double ElementJudge::least_along(const Corners& v, int n) const {
  Vec3 area, corners;
  double least = 1;
  for (int k = 0; k < n; ++k) {
    area += cross(mesh_.x[v[k]] - mesh_.x[v[0]], mesh_.x[v[(k + 1) % n]] - mesh_.x[v[0]]);
    corners += mesh_.normal(v[k]);
  }
  area = unit(area);
  for (int k = 0; k < n; ++k) least = std::min(least, dot(area, mesh_.normal(v[k])));
  return runs_with_surface(region_, n, places(v, n), {area, area, corners}) ? std::max(least, 0.0) : -1;
}

// The element as curved, all of it and at its centre, as the check that follows measures it: its chords may run with
// the surface where it does not.
bool ElementJudge::runs_against(const Corners& v, int n, const std::array<Vec3, 9>& x) const {
  if (order_ == 1) return false;
  const auto node = [&](int k) { return x[k]; };
  ElementNormals normals{twice_area(n, true, node), centre_normal(n, node), {}};
  for (int k = 0; k < n; ++k) normals.corners += mesh_.normal(v[k]);
  return !runs_with_surface(region_, n, places(v, n), normals);
}

// As a share of what may be: of the target length, and no more than that of the element's own size.
double ElementJudge::off_surface(const Corners& v, int n, const std::array<Vec3, 9>& x) const {
  if (order_ == 1) return chords_off(v, n);
  const double size = std::max(norm(x[2] - x[0]), norm(x[n - 1] - x[1]));
  const double most = most_off_moved * region_.h, most_of_own = std::min(most, most_off_moved * size);
  const double off = deviation(region_, {n, order_, x}, places(v, n), far * most_of_own);
  return off / (off > most_of_own ? most_of_own : most);
}

const ElementJudge::KnownSide& ElementJudge::known_side(int a, int b) const {
  if (known_.empty()) known_.resize(most_known);
  KnownSide& side = known_[(static_cast<std::size_t>(a) * 0x9E3779B1U + static_cast<std::size_t>(b)) % most_known];
  if (side.a != a || side.b != b || side.from != mesh_.p[a] || side.to != mesh_.p[b]) {
    side = {a, b, mesh_.p[a], mesh_.p[b], guess_middle(region_, mesh_, a, b, {}), {}};
    const SideEnd from = side_end(mesh_, a, mesh_.x[a]), to = side_end(mesh_, b, mesh_.x[b]);
    side.middle = side_middle(region_, from, to, sides_.bulges().beside(from, to), side.place);
  }
  return side;
}

std::array<Vec3, 9> ElementJudge::curved(const Corners& v, int n) const {
  std::array<Vec3, 9> x;
  std::array<Vec2, 4> middles;
  for (int k = 0; k < n; ++k) x[k] = mesh_.x[v[k]];
  for (int k = 0; k < n; ++k) {
    const int a = v[k], b = v[(k + 1) % n];
    if (const BoundarySide* side = sides_.find(mesh_.global[a], mesh_.global[b])) {
      x[n + k] = side->middle;
      middles[k] = guess_middle(region_, mesh_, a, b, side->middle - 0.5 * (mesh_.x[a] + mesh_.x[b]));
    } else {
      const KnownSide& known = known_side(std::min(a, b), std::max(a, b));
      middles[k] = known.place, x[n + k] = known.middle;
    }
  }
  if (n == 3) return x;
  Vec2 place = guess_centre(region_, mesh_, v, middles);
  x[8] = nearest_point(region_, place, blend_of(x), norm(x[2] - x[0]));
  return x;
}

double ElementJudge::chords_off(const Corners& v, int n) const {
  Vec2 place;
  Vec3 centre;
  double most = 0;
  auto add = [&](Vec2 p, Vec3 target, double scale, double allowed) {
    most = std::max(most, distance_to_surface(region_, p, target, scale, most * allowed) / allowed);
  };
  for (int k = 0; k < n; ++k) {
    const int a = v[k], b = v[(k + 1) % n];
    place = place + (1.0 / n) * mesh_.p[a];
    centre += (1.0 / n) * mesh_.x[a];
    if (mesh_.global[a] >= 0 && mesh_.global[b] >= 0) continue;
    add(guess_middle(region_, mesh_, a, b, {}), 0.5 * (mesh_.x[a] + mesh_.x[b]), norm(mesh_.x[b] - mesh_.x[a]),
        most_off_side * region_.h);
  }
  add(place, centre, norm(mesh_.x[v[2]] - mesh_.x[v[0]]), most_off_centre * region_.h);
  return most;
}

// Where two edges touch each other without an angle no element is valid unless it leaves them.
bool ElementJudge::is_valid_cusp(const Corners& v, int n, std::array<Vec3, 9> x) const {
  if (order_ == 1) return false;
  const double most = most_off_moved * region_.h;
  bool has_cusp = false;
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n, last = (k + n - 1) % n;
    if (!sides_.find(mesh_.global[v[k]], mesh_.global[v[next]]) ||
        !sides_.find(mesh_.global[v[last]], mesh_.global[v[k]]))
      continue;
    const Vec3 out = unit(4 * x[n + k] - 3 * x[k] - x[next]), back = unit(4 * x[n + last] - 3 * x[k] - x[last]);
    if (norm(cross(out, back)) > cusp_sine || dot(out, back) < 0) continue;
    has_cusp = true;
    for (auto [side, a, b] : {std::array{n + k, k, next}, std::array{n + last, last, k}}) {
      const Vec3 middle = 0.5 * (x[a] + x[b]);
      if (norm(x[side] - middle) > most) return false;
      x[side] = middle;
    }
  }
  if (!has_cusp) return false;
  if (n == 4) x[8] = blend_of(x);
  return form_of(n, order_).is_valid(x.data());
}

std::array<Vec3, 9> ElementJudge::nodes(const Corners& v, int n) const {
  if (order_ > 1) return curved(v, n);
  return {mesh_.x[v[0]], mesh_.x[v[1]], mesh_.x[v[2]], mesh_.x[v[n - 1]]};
}

ElementArea ElementJudge::area(const Corners& v) const {
  const int n = Element{v}.corners();
  const std::array<Vec3, 9> x = nodes(v, n);
  const Vec3 twice = twice_area(n, order_ > 1, [&](int k) { return x[k]; });
  double along = 1;
  for (int k = 0; k < n; ++k)
    if (const Vec3 normal = mesh_.normal(v[k]); dot(normal, normal) > 0)
      along = std::min(along, dot(unit(twice), normal));
  return {form_of(n, order_).area(x.data()), element_slack(0.5 * norm(twice), along, order_ > 1)};
}

double ElementJudge::worst_value() const {
  double worst = 1;
  for (const Element& e : mesh_.elements)
    if (e.is_alive()) worst = std::min(worst, value(e.v));
  return worst;
}

double ElementJudge::value(const Corners& v, double floor) const {
  const Element element{v};
  const int n = element.corners();
  if (has_node_twice(mesh_, element) || !turns_left(mesh_, element)) return folded;
  if (!forbidden_.empty() && has_forbidden_side(v, n)) return folded;
  const double along = least_along(v, n);
  if (along < 0) return folded;
  const double sj = scaled_jacobian(mesh_, element);
  if (sj < least_height) return std::min(sj, 0.0);
  if (sj <= floor) return sj;
  const std::array<Vec3, 9> x = nodes(v, n);
  const JacobianBound bound = form_of(n, order_).bound(x.data(), std::min(sj, JacobianForm::poor_ratio));
  if (bound.validity != Validity::valid)
    return is_valid_cusp(v, n, x) ? value_of_cusp : std::clamp(bound.ratio, -1.0, 0.0) - 1e-3;
  if (runs_against(v, n, x)) return folded;
  const double off = along < (order_ == 1 ? nearly_flat : steep) ? off_surface(v, n, x) : 0;
  if (off > 1) return std::max(1 - off, -1.0);
  return std::min({sj, bound.ratio, order_ > 1 && off > far ? very_poor * (1 - off) / (1 - far) : 1});
}

}  // namespace paver
