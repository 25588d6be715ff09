// Smoothing sweeps: one pass over the elements gathers the wishes, one over the
// nodes moves them, one over the elements finds those that became bad, whose
// nodes go back until nothing is bad. With all nodes back the mesh is as
// before, so a sweep always ends and never leaves an element inverted or a poor
// one poorer.
#include "paving/cleanup_smooth.h"

#include <algorithm>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double over_relaxation = 1.6;  // thirty such sweeps even out lengths as sixty plain ones do

bool is_positive(const RegionMesh& mesh, const Element& e) {
  int n = e.corners();
  for (int i = 0; i < (n == 3 ? 1 : 4); ++i)
    if (orientation(mesh.p[e.v[i]], mesh.p[e.v[(i + 1) % n]], mesh.p[e.v[(i + 2) % n]]) <= 0) return false;
  return true;
}

}  // namespace

int wished_corners(const RegionMesh& mesh, const Element& e, Vec3 at[4]) {
  if (e.corners() == 4) {
    Vec3 x0 = mesh.x[e.v[0]], x1 = mesh.x[e.v[1]], x2 = mesh.x[e.v[2]], x3 = mesh.x[e.v[3]];
    Vec3 centre = 0.25 * (x0 + x1 + x2 + x3), d1 = x2 - x0, d2 = x3 - x1;
    Vec3 n = unit(cross(d1, d2));
    Vec3 r = 0.5 * (d1 - cross(n, d2));  // towards corner 2; corner 3 is a quarter turn on
    double own = 0.5 * norm(r);          // half a diagonal
    if (!(own > 0)) return 0;
    double target = 0.25 * M_SQRT1_2 * (mesh.h[e.v[0]] + mesh.h[e.v[1]] + mesh.h[e.v[2]] + mesh.h[e.v[3]]);
    r = (target / (2 * own)) * r;
    Vec3 q = cross(n, r);
    at[0] = centre - r, at[1] = centre - q, at[2] = centre + r, at[3] = centre + q;
    return 4;
  }
  Vec3 x0 = mesh.x[e.v[0]], x1 = mesh.x[e.v[1]], x2 = mesh.x[e.v[2]];
  Vec3 centre = (1.0 / 3) * (x0 + x1 + x2), n = unit(cross(x1 - x0, x2 - x0));
  constexpr double s = 0.86602540378443865;
  auto turn = [&](Vec3 v, double sine) { return -0.5 * v + sine * cross(n, v); };
  Vec3 r = (1.0 / 3) * ((x0 - centre) + turn(x1 - centre, -s) + turn(x2 - centre, s));
  double own = norm(r), target = (mesh.h[e.v[0]] + mesh.h[e.v[1]] + mesh.h[e.v[2]]) / (6 * s);
  if (!(own > 0)) return 0;
  r = (target / own) * r;
  at[0] = centre + r, at[1] = centre + turn(r, s), at[2] = centre + turn(r, -s);
  return 3;
}

Sweeper::Sweeper(Front& front) : front_(front), mesh_(front.mesh) {
  sj_.resize(mesh_.elements.size());
  for (std::size_t e = 0; e < sj_.size(); ++e)
    sj_[e] = mesh_.elements[e].is_alive() ? capped_jacobian(mesh_.elements[e]) : 0;
  old_sj_ = sj_;
}

double Sweeper::capped_jacobian(const Element& e) const {
  int n = e.corners();
  Vec3 side[4];
  double length2[4];
  for (int i = 0; i < n; ++i) {
    side[i] = mesh_.x[e.v[(i + 1) % n]] - mesh_.x[e.v[i]];
    length2[i] = dot(side[i], side[i]);
  }
  Vec3 area = n == 3 ? cross(side[0], side[1]) : cross(side[0] + side[1], side[1] + side[2]);
  double bound = good_jacobian * good_jacobian * dot(area, area) * (n == 3 ? 0.75 : 1);
  for (int i = 0; i < n; ++i) {
    int j = (i + n - 1) % n;
    double s = dot(cross(side[j], side[i]), area);
    if (!(s > 0 && s * s >= bound * length2[i] * length2[j])) return std::min(good_jacobian, scaled_jacobian(mesh_, e));
  }
  return good_jacobian;
}

void Sweeper::move_nodes() {
  has_moved_.assign(mesh_.p.size(), 0);
  for (int i = 0; i < mesh_.node_count(); ++i) {
    int size = mesh_.star[i].size();
    if (mesh_.is_fixed[i] || size == 0) continue;
    Vec3 step = over_relaxation * ((1.0 / size) * sum_[i] - mesh_.x[i]);
    mesh_.p[i] = mesh_.p[i] + mesh_.pull_back(i, step);
    front_.region.evaluate(mesh_.p[i], mesh_.x[i], mesh_.xp[i], mesh_.xq[i]);
    has_moved_[i] = 1;
  }
}

bool Sweeper::check(int e) {
  if (!is_positive(mesh_, mesh_.elements[e])) return false;
  sj_[e] = capped_jacobian(mesh_.elements[e]);
  return sj_[e] >= good_jacobian || sj_[e] >= old_sj_[e];
}

void Sweeper::take_back_bad() {
  stack_.clear();
  auto collect = [&](int e) {
    for (int v : mesh_.elements[e].v)
      if (v >= 0 && has_moved_[v]) stack_.push_back(v);
  };
  for (std::size_t e = 0; e < sj_.size(); ++e)
    if (mesh_.elements[e].is_alive() && !check(static_cast<int>(e))) collect(static_cast<int>(e));
  while (!stack_.empty()) {
    int node = stack_.back();
    stack_.pop_back();
    if (!has_moved_[node]) continue;
    has_moved_[node] = 0;
    mesh_.p[node] = old_p_[node], mesh_.x[node] = old_x_[node];
    mesh_.xp[node] = old_xp_[node], mesh_.xq[node] = old_xq_[node];
    for (int e : mesh_.star[node])
      if (!check(e)) collect(e);
  }
}

void Sweeper::sweep() {
  sum_.assign(mesh_.p.size(), Vec3{0, 0, 0});
  for (const Element& e : mesh_.elements) {
    if (!e.is_alive()) continue;
    Vec3 at[4];
    int n = wished_corners(mesh_, e, at);
    for (int i = 0; i < e.corners(); ++i) sum_[e.v[i]] += n ? at[i] : mesh_.x[e.v[i]];
  }
  old_p_ = mesh_.p, old_x_ = mesh_.x, old_xp_ = mesh_.xp, old_xq_ = mesh_.xq, old_sj_ = sj_;
  move_nodes();
  take_back_bad();
}

}  // namespace paver
