// Connectivity edits of a region's mesh and the scaled Jacobian of one element.
#include "mesh/region_mesh.h"

#include <algorithm>
#include <type_traits>

#include "base/predicates.h"

namespace paver {

long RegionMesh::living_elements() const {
  return std::count_if(elements.begin(), elements.end(), [](const Element& e) { return e.is_alive(); });
}

long RegionMesh::triangle_count() const {
  return std::count_if(elements.begin(), elements.end(),
                       [](const Element& e) { return e.is_alive() && e.corners() == 3; });
}

void RegionMesh::reserve(std::size_t count) {
  p.reserve(count), x.reserve(count), xp.reserve(count), xq.reserve(count), drift.reserve(count), h.reserve(count);
  is_fixed.reserve(count), global.reserve(count), star.reserve(count);
  elements.reserve(count + count / 2);  // those that went stay, as gaps
}

int RegionMesh::add_node(const NodePlace& at, double target) {
  p.push_back(at.p);
  x.push_back(at.x);
  xp.push_back(at.xp);
  xq.push_back(at.xq);
  drift.push_back(at.drift);
  if (has_turns()) turn.push_back({at.n, at.np, at.nq});
  h.push_back(target);
  is_fixed.push_back(0);
  global.push_back(-1);
  star.emplace_back();
  return node_count() - 1;
}

void RegionMesh::drop_last_node() {
  p.pop_back(), x.pop_back(), xp.pop_back(), xq.pop_back(), drift.pop_back();
  if (has_turns()) turn.pop_back();
  h.pop_back(), is_fixed.pop_back(), global.pop_back(), star.pop_back();
}

NodePlace RegionMesh::place(int node) const {
  NodePlace at{p[node], x[node], xp[node], xq[node], {}, {}, {}, drift[node]};
  if (has_turns()) {
    const NodeTurn& t = turn[node];
    at.n = t.n, at.np = t.np, at.nq = t.nq;
  }
  return at;
}

void RegionMesh::put(int node, const NodePlace& at) {
  p[node] = at.p, x[node] = at.x, xp[node] = at.xp, xq[node] = at.xq, drift[node] = at.drift;
  if (has_turns()) turn[node] = {at.n, at.np, at.nq};
}

int RegionMesh::add_element(const Corners& corners) {
  int e = static_cast<int>(elements.size());
  elements.emplace_back();
  restore_element(e, corners);
  return e;
}

void RegionMesh::remove_element(int e) {
  for (int v : elements[e].nodes()) star[v].remove(e);
  elements[e].v = {-1, -1, -1, -1};
}

void RegionMesh::restore_element(int e, const Corners& corners) {
  elements[e].v = corners;
  for (int v : elements[e].nodes()) star[v].add(e);
}

void RegionMesh::find_stars() {
  star.assign(p.size(), {});
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (int v : elements[e].nodes()) star[v].add(static_cast<int>(e));
}

void RegionMesh::replace_node(int e, int from, int to) {
  elements[e].v[elements[e].corner_of(from)] = to;
  star[from].remove(e);
  star[to].add(e);
}

double RegionMesh::scale_at(int node) const {
  double least = h[node] * h[node];
  for (int e : star[node]) {
    const MetricVec side = between(node, elements[e].after(node));
    least = std::min(least, dot(side, side));
  }
  return std::sqrt(least);
}

Vec2 RegionMesh::pull_back(int node, const MetricVec& v) const {
  const MetricVec s = tangent_p(node), t = tangent_q(node);
  double ss = dot(s, s), st = dot(s, t), tt = dot(t, t), vs = dot(v, s), vt = dot(v, t);
  double det = ss * tt - st * st;
  if (!(det > 0)) return {0, 0};
  return {(tt * vs - st * vt) / det, (ss * vt - st * vs) / det};
}

namespace {

constexpr double skew_allowance = 1.4;              // in space elements may be so much more skew than in the metric
constexpr double equilateral = 1.1547005383792515;  // by the sine of 60 degrees

/// Sides of an element and its plane: that of the first two sides of a triangle, of a quad that of its mid lines. Areas
/// are products in that plane, so no root is taken. V: Vec3 where turns do not count, which is less work.
template <class V>
struct Sides {
  int count;
  V side[4];
  double length2[4];
  double first[4], second[4];  // sides by the two vectors of the plane
  double area2;                // of the two vectors, squared
  Sides(const RegionMesh& mesh, const Element& e) : count(e.corners()) {
    for (int i = 0; i < count; ++i) {
      const int a = e.v[i], b = e.v[i + 1 < count ? i + 1 : 0];
      if constexpr (std::is_same_v<V, Vec3>)
        side[i] = mesh.x[b] - mesh.x[a];
      else
        side[i] = mesh.between(a, b);
      length2[i] = dot(side[i], side[i]);
    }
    const V one = count == 3 ? side[0] : side[0] - side[2], other = count == 3 ? side[1] : side[1] - side[3];
    for (int i = 0; i < count; ++i) first[i] = dot(side[i], one), second[i] = dot(side[i], other);
    const double mixed = dot(one, other);
    area2 = dot(one, one) * dot(other, other) - mixed * mixed;
  }
  /// The corner between side j and side i, as a product of areas.
  double corner(int j, int i) const { return first[j] * second[i] - second[j] * first[i]; }
};

template <class V>
bool has_corners(const Sides<V>& s, double bound) {
  if (s.count == 3) bound /= equilateral;
  const double least = bound * bound * s.area2;
  for (int i = 0; i < s.count; ++i) {
    const int j = i > 0 ? i - 1 : s.count - 1;
    const double sine = s.corner(j, i);
    if (!(sine > 0 && sine * sine >= least * s.length2[i] * s.length2[j])) return false;
  }
  return true;
}

/// Of the corners but those with a bit in `left_out`.
template <class V>
double worst_corner(const Sides<V>& s, unsigned left_out = 0) {
  double worst = 2;
  for (int i = 0; i < s.count; ++i) {
    if (left_out >> i & 1U) continue;
    const int j = i > 0 ? i - 1 : s.count - 1;
    const double scale = std::sqrt(s.length2[i] * s.length2[j] * std::max(s.area2, 0.0));
    worst = std::min(worst, scale > 0 ? s.corner(j, i) / scale : -1);
  }
  return s.count == 3 ? worst * equilateral : worst;
}

Vec3 area_vector(const RegionMesh& mesh, const Element& e) {
  const auto& x = mesh.x;
  return e.corners() == 3 ? cross(x[e.v[1]] - x[e.v[0]], x[e.v[2]] - x[e.v[0]])
                          : cross(x[e.v[2]] - x[e.v[0]], x[e.v[3]] - x[e.v[1]]);
}

// A corner without a normal, at a pole, turns to none: the metric says nothing of the angle there.
bool counts_turns(const RegionMesh& mesh, const Element& e) {
  return mesh.has_turns() && std::ranges::none_of(e.nodes(), [&](int v) { return mesh.turn[v].n == Vec3{}; });
}

}  // namespace

bool faces_surface(const RegionMesh& mesh, const Element& e) {
  int fixed = 0;
  for (int v : e.nodes()) fixed += mesh.is_fixed[v];
  if (fixed < 2) return true;
  Vec3 normal{};
  for (int v : e.nodes()) normal += mesh.normal(v);
  return dot(area_vector(mesh, e), normal) >= 0;
}

bool turns_left(const RegionMesh& mesh, const Element& e) {
  const int n = e.corners();
  for (int i = 0; i < (n == 3 ? 1 : 4); ++i)
    if (orientation(mesh.p[e.v[i]], mesh.p[e.v[(i + 1) % n]], mesh.p[e.v[(i + 2) % n]]) <= 0) return false;
  return true;
}

bool is_positive(const RegionMesh& mesh, const Element& e) { return turns_left(mesh, e) && faces_surface(mesh, e); }

bool are_all_positive(const RegionMesh& mesh) {
  return std::all_of(mesh.elements.begin(), mesh.elements.end(),
                     [&](const Element& e) { return is_positive(mesh, e); });
}

bool has_node_twice(const RegionMesh& mesh, const Element& e) {
  for (int i = 0, n = e.corners(); i < n; ++i)
    for (int j = 0; j < i; ++j)
      if (e.v[i] == e.v[j] || (mesh.global[e.v[i]] >= 0 && mesh.global[e.v[i]] == mesh.global[e.v[j]])) return true;
  return false;
}

bool has_jacobian(const RegionMesh& mesh, const Element& e, double bound) {
  if (!counts_turns(mesh, e)) return has_corners(Sides<Vec3>(mesh, e), bound);
  return has_corners(Sides<Vec3>(mesh, e), bound / skew_allowance) && has_corners(Sides<MetricVec>(mesh, e), bound);
}

double scaled_jacobian(const RegionMesh& mesh, const Element& e, unsigned left_out) {
  const double plain = worst_corner(Sides<Vec3>(mesh, e), left_out);
  if (!counts_turns(mesh, e)) return plain;
  return std::min(skew_allowance * plain, worst_corner(Sides<MetricVec>(mesh, e), left_out));
}

double positive_jacobian(const RegionMesh& mesh, const Corners& corners) {
  const Element element{corners};
  return is_positive(mesh, element) ? scaled_jacobian(mesh, element) : -1;
}

double worst_about(const RegionMesh& mesh, int node) {
  double worst = 2;
  for (int e : mesh.star[node]) worst = std::min(worst, scaled_jacobian(mesh, mesh.elements[e]));
  return worst;
}

}  // namespace paver
