// Smoothing sweeps: one pass over the elements gathers the wishes, one over the
// nodes moves them, one over the elements finds those that became bad, whose
// nodes go back until nothing is bad. With all nodes back the mesh is as
// before, so a sweep always ends and never leaves an element inverted or a poor
// one poorer.
#include "paving/cleanup/sweeper.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double collinear = 1e-24;  // square of a diagonal's height over the other, by that one's square

// With momentum a dozen sweeps even out lengths as thirty over-relaxed ones or sixty plain ones do.
constexpr double over_relaxation = 1.3, momentum = 0.7;
constexpr double still = 0.004;  // step by the scale of the mesh below which a node rests

}  // namespace

namespace {

// The two diagonals of a square lie a quarter turn apart: the mean of one and of the other turned back is its first.
template <class V>
bool square_steps(const V at[4], double target, V step[4]) {
  const V centre = 0.25 * (at[0] + at[1] + at[2] + at[3]), d1 = at[2] - at[0], d2 = at[3] - at[1];
  const double first2 = dot(d1, d1), mixed = dot(d1, d2), area2 = first2 * dot(d2, d2) - mixed * mixed;
  if (!(first2 > 0 && area2 > collinear * first2 * first2)) return false;
  const double length = std::sqrt(first2), height = std::sqrt(area2) / length;  // of d2 over d1
  const V f1 = (1 / length) * d1, f2 = (1 / height) * (d2 - (mixed / first2) * d1);
  const double rx = length + height, ry = -mixed / length;
  const double half = M_SQRT1_2 * target / std::sqrt(rx * rx + ry * ry);  // half a diagonal, by the length of r
  const V r = (half * rx) * f1 + (half * ry) * f2, q = (-half * ry) * f1 + (half * rx) * f2;
  step[0] = centre - r - at[0], step[1] = centre - q - at[1];
  step[2] = centre + r - at[2], step[3] = centre + q - at[3];
  return true;
}

// The same for the three spokes of an equilateral triangle, a third of a turn apart.
template <class V>
bool triangle_steps(const V at[3], double target, V step[3]) {
  constexpr double s = 0.86602540378443865;
  const V centre = (1.0 / 3) * (at[0] + at[1] + at[2]), d1 = at[1] - at[0], d2 = at[2] - at[0];
  const double first2 = dot(d1, d1), mixed = dot(d1, d2), area2 = first2 * dot(d2, d2) - mixed * mixed;
  if (!(first2 > 0 && area2 > collinear * first2 * first2)) return false;
  const double length = std::sqrt(first2), height = std::sqrt(area2) / length;
  const V f1 = (1 / length) * d1, f2 = (1 / height) * (d2 - (mixed / first2) * d1);
  auto flat = [&](const V& v) { return Vec2{dot(v, f1), dot(v, f2)}; };
  auto turned = [&](Vec2 v, double sine) { return Vec2{-0.5 * v.x - sine * v.y, sine * v.x - 0.5 * v.y}; };
  const Vec2 sum = flat(at[0] - centre) + turned(flat(at[1] - centre), -s) + turned(flat(at[2] - centre), s);
  const double own = norm(sum);
  if (!(own > 0)) return false;
  const Vec2 r = (target / (2 * s * own)) * sum;
  const Vec2 spokes[3] = {r, turned(r, s), turned(r, -s)};
  for (int k = 0; k < 3; ++k) step[k] = centre + spokes[k].x * f1 + spokes[k].y * f2 - at[k];
  return true;
}

// In the metric skew of elements that turns stretch counts for little: in space their short mid line is to be square to
// the long one, as far as the metric has it longer than space.
void add_square_steps_in_space(const MetricVec at[4], MetricVec step[4]) {
  const MetricVec across = 0.5 * (at[1] + at[2] - at[0] - at[3]), up = 0.5 * (at[2] + at[3] - at[0] - at[1]);
  const bool is_wide = dot(across.x, across.x) > dot(up.x, up.x);
  const MetricVec &wide = is_wide ? across : up, &narrow = is_wide ? up : across;
  const double wide2 = dot(wide.x, wide.x), narrow2 = dot(narrow, narrow);
  if (!(wide2 > 0 && narrow2 > 0)) return;
  const double share = 1 - dot(narrow.x, narrow.x) / narrow2;
  const Vec3 shift = (0.5 * share * dot(wide.x, narrow.x) / wide2) * wide.x;
  for (int k = 0; k < 4; ++k) {
    const bool is_ahead = is_wide ? k >= 2 : k == 1 || k == 2;
    step[k].x = is_ahead ? step[k].x - shift : step[k].x + shift;
  }
}

double mean_target(const RegionMesh& mesh, const Element& e) {
  double sum = 0;
  for (int k = 0; k < e.corners(); ++k) sum += mesh.h[e.v[k]];
  return sum / e.corners();
}

}  // namespace

bool wished_steps(const RegionMesh& mesh, const Element& e, MetricVec step[4]) {
  const int n = e.corners();
  const double target = mean_target(mesh, e);
  if (mesh.has_turns()) {
    const MetricVec at[4] = {{},
                             mesh.between(e.v[0], e.v[1]),
                             mesh.between(e.v[0], e.v[2]),
                             n == 4 ? mesh.between(e.v[0], e.v[3]) : MetricVec{}};
    if (n == 3) return triangle_steps(at, target, step);
    if (!square_steps(at, target, step)) return false;
    add_square_steps_in_space(at, step);
    return true;
  }
  const Vec3 at[4] = {mesh.x[e.v[0]], mesh.x[e.v[1]], mesh.x[e.v[2]], n == 4 ? mesh.x[e.v[3]] : Vec3{}};
  Vec3 flat[4];
  if (!(n == 4 ? square_steps(at, target, flat) : triangle_steps(at, target, flat))) return false;
  for (int k = 0; k < n; ++k) step[k] = {flat[k], {}};
  return true;
}

Sweeper::Sweeper(Front& front) : front_(front), mesh_(front.mesh) {
  const std::size_t node_count = mesh_.p.size(), element_count = mesh_.elements.size();
  sum_.resize(node_count), last_.resize(node_count), scale_.resize(node_count), moved_as_.assign(node_count, -1),
      seen_node_.assign(node_count, 0);
  sj_.resize(element_count), old_sj_.resize(element_count), seen_.assign(element_count, 0);
  for (std::size_t e = 0; e < element_count; ++e)
    if (mesh_.elements[e].is_alive()) sj_[e] = capped_jacobian(mesh_.elements[e]);
  for (int i = 0; i < mesh_.node_count(); ++i) add_node(i);
  nodes_.swap(next_);
  for (int i : nodes_) scale_[i] = static_cast<float>(mesh_.scale_at(i));
}

void Sweeper::add_node(int node) {
  if (mesh_.is_fixed[node] || mesh_.star[node].size() == 0) return;
  next_.push_back(node);
}

float Sweeper::capped_jacobian(const Element& e) const {
  double sj = has_jacobian(mesh_, e, good_jacobian) ? good_jacobian : scaled_jacobian(mesh_, e);
  return static_cast<float>(std::min(good_jacobian, sj));
}

void Sweeper::collect_elements() {
  elements_.clear();
  for (int node : nodes_)
    for (int e : mesh_.star[node]) {
      if (seen_[e] == run_) continue;
      seen_[e] = run_;
      elements_.push_back(e);
    }
}

void Sweeper::gather_wishes() {
  for (int node : nodes_) sum_[node] = {};
  for (int e : elements_) {
    const Element& element = mesh_.elements[e];
    MetricVec steps[4];
    if (!wished_steps(mesh_, element, steps)) continue;
    for (int i = 0; i < element.corners(); ++i) sum_[element.v[i]] += steps[i];
  }
}

void Sweeper::move_nodes() {
  old_.resize(nodes_.size());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    int i = nodes_[k];
    const Vec2 wished = mesh_.pull_back(i, sum_[i]);
    const Vec2 step = (over_relaxation / mesh_.star[i].size()) * wished + momentum * last_[i];
    last_[i] = step;
    if (!(norm(mesh_.push(i, step)) > still * scale_[i])) continue;
    old_[k] = mesh_.p[i], sum_[i] = mesh_.point(i);
    front_.slide(i, mesh_.p[i] + step, scale_[i]);
    moved_as_[i] = static_cast<int>(k);
  }
}

bool Sweeper::check(int e) {
  if (!is_positive(mesh_, mesh_.elements[e])) return false;
  sj_[e] = capped_jacobian(mesh_.elements[e]);
  return sj_[e] >= static_cast<float>(good_jacobian) || sj_[e] >= old_sj_[e];
}

void Sweeper::take_back_bad() {
  stack_.clear();
  auto collect = [&](int e) {
    for (int v : mesh_.elements[e].v)
      if (v >= 0 && moved_as_[v] >= 0) stack_.push_back(v);
  };
  for (int e : elements_) {
    old_sj_[e] = sj_[e];
    if (!check(e)) collect(e);
  }
  while (!stack_.empty()) {
    int node = stack_.back();
    stack_.pop_back();
    if (moved_as_[node] < 0) continue;
    const Vec2 old = old_[moved_as_[node]];
    moved_as_[node] = -1;
    // Derivatives stay those of where it was evaluated last: to be evaluated at its next move.
    mesh_.p[node] = old, mesh_.x[node] = sum_[node].x, mesh_.drift[node] = 1, last_[node] = {};
    if (mesh_.has_turns()) mesh_.turn[node].n = sum_[node].n;
    for (int e : mesh_.star[node])
      if (!check(e)) collect(e);
  }
}

// Nodes of all elements in which something moved.
void Sweeper::collect_nodes() {
  next_.clear();
  for (int e : elements_) {
    const auto& v = mesh_.elements[e].v;
    auto has_moved = [&](int node) { return node >= 0 && moved_as_[node] >= 0; };
    if (std::none_of(v.begin(), v.end(), has_moved)) continue;
    for (int node : v) {
      if (node < 0 || seen_node_[node] == run_) continue;
      seen_node_[node] = run_;
      add_node(node);
    }
  }
  for (int node : nodes_) moved_as_[node] = -1;
}

bool Sweeper::sweep() {
  ++run_;
  collect_elements();
  gather_wishes();
  move_nodes();
  take_back_bad();
  collect_nodes();
  nodes_.swap(next_);
  return !nodes_.empty();
}

}  // namespace paver
