// Connectivity edits of a region's mesh and the scaled Jacobian of one element.
#include "mesh/region_mesh.h"

#include "base/predicates.h"

namespace paver {

void RegionMesh::reserve(std::size_t count) {
  p.reserve(count), x.reserve(count), xp.reserve(count), xq.reserve(count), drift.reserve(count), h.reserve(count);
  is_fixed.reserve(count), global.reserve(count), star.reserve(count);
  elements.reserve(count + count / 2);  // those that went stay, as gaps
}

int RegionMesh::add_node(Vec2 chart, Vec3 position, Vec3 tangent_p, Vec3 tangent_q, double target) {
  p.push_back(chart);
  x.push_back(position);
  xp.push_back(tangent_p);
  xq.push_back(tangent_q);
  drift.push_back(0);
  h.push_back(target);
  is_fixed.push_back(0);
  global.push_back(-1);
  star.emplace_back();
  return node_count() - 1;
}

void RegionMesh::drop_last_node() {
  p.pop_back(), x.pop_back(), xp.pop_back(), xq.pop_back(), drift.pop_back();
  h.pop_back(), is_fixed.pop_back(), global.pop_back(), star.pop_back();
}

int RegionMesh::add_element(const std::array<int, 4>& corners) {
  int e = static_cast<int>(elements.size());
  elements.push_back({corners});
  for (int v : corners)
    if (v >= 0) star[v].add(e);
  return e;
}

void RegionMesh::remove_element(int e) {
  for (int v : elements[e].v)
    if (v >= 0) star[v].remove(e);
  elements[e].v = {-1, -1, -1, -1};
}

void RegionMesh::restore_element(int e, const std::array<int, 4>& corners) {
  elements[e].v = corners;
  for (int v : corners)
    if (v >= 0) star[v].add(e);
}

void RegionMesh::replace_node(int e, int from, int to) {
  elements[e].v[elements[e].corner_of(from)] = to;
  star[from].remove(e);
  star[to].add(e);
}

double RegionMesh::scale_at(int node) const {
  double least = h[node] * h[node];
  for (int e : star[node]) {
    Vec3 side = x[elements[e].after(node)] - x[node];
    least = std::min(least, dot(side, side));
  }
  return std::sqrt(least);
}

Vec2 RegionMesh::pull_back(int node, Vec3 v) const {
  Vec3 s = xp[node], t = xq[node];
  double ss = dot(s, s), st = dot(s, t), tt = dot(t, t), vs = dot(v, s), vt = dot(v, t);
  double det = ss * tt - st * st;
  if (!(det > 0)) return {0, 0};
  return {(tt * vs - st * vt) / det, (ss * vt - st * vs) / det};
}

namespace {

constexpr double equilateral = 1.1547005383792515;  // by the sine of 60 degrees

struct Sides {
  int count;
  Vec3 side[4], area;
  double length2[4];
  Sides(const RegionMesh& mesh, const Element& e) : count(e.corners()) {
    for (int i = 0; i < count; ++i) {
      side[i] = mesh.x[e.v[i + 1 < count ? i + 1 : 0]] - mesh.x[e.v[i]];
      length2[i] = dot(side[i], side[i]);
    }
    area = count == 3 ? cross(side[0], side[1]) : cross(side[0] + side[1], side[1] + side[2]);
  }
};

}  // namespace

bool faces_surface(const RegionMesh& mesh, const Element& e) {
  const int n = e.corners();
  int fixed = 0;
  for (int i = 0; i < n; ++i) fixed += mesh.is_fixed[e.v[i]];
  if (fixed < 2) return true;
  Vec3 normal{};
  for (int i = 0; i < n; ++i) normal += mesh.normal(e.v[i]);
  return dot(Sides(mesh, e).area, normal) >= 0;
}

bool is_positive(const RegionMesh& mesh, const Element& e) {
  const int n = e.corners();
  for (int i = 0; i < (n == 3 ? 1 : 4); ++i)
    if (orientation(mesh.p[e.v[i]], mesh.p[e.v[(i + 1) % n]], mesh.p[e.v[(i + 2) % n]]) <= 0) return false;
  return faces_surface(mesh, e);
}

bool has_jacobian(const RegionMesh& mesh, const Element& e, double bound) {
  const Sides s(mesh, e);
  if (s.count == 3) bound /= equilateral;
  double least = bound * bound * dot(s.area, s.area);
  for (int i = 0; i < s.count; ++i) {
    int j = i > 0 ? i - 1 : s.count - 1;
    double sine = dot(cross(s.side[j], s.side[i]), s.area);
    if (!(sine > 0 && sine * sine >= least * s.length2[i] * s.length2[j])) return false;
  }
  return true;
}

double scaled_jacobian(const RegionMesh& mesh, const Element& e) {
  const Sides s(mesh, e);
  double area_norm = norm(s.area), worst = 2;
  for (int i = 0; i < s.count; ++i) {
    int j = i > 0 ? i - 1 : s.count - 1;
    double scale = std::sqrt(s.length2[i] * s.length2[j]) * area_norm;
    double sj = scale > 0 ? dot(cross(s.side[j], s.side[i]), s.area) / scale : -1;
    worst = std::min(worst, sj);
  }
  return s.count == 3 ? worst * equilateral : worst;
}

}  // namespace paver
