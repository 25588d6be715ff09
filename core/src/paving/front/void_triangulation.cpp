// Constrained Delaunay triangulation with insertion, segment recovery by re-triangulating the crossed triangles,
// and removal. All orientation decisions are exact, so every triangle has positive area in the chart at all times.
#include "paving/front/void_triangulation.h"

#include <algorithm>

#include "base/box.h"
#include "base/predicates.h"

namespace paver {

int VoidTriangulation::make(int a, int b, int c) {
  int t;
  if (free_.empty()) {
    t = triangle_count();
    triangles_.emplace_back();
  } else {
    t = free_.back();
    free_.pop_back();
  }
  triangles_[t] = {{a, b, c}, {-1, -1, -1}, true};
  note(t);
  return t;
}

// While building, every node knows a triangle at it.
void VoidTriangulation::note(int t) {
  if (hint_.empty()) return;
  for (int v : triangles_[t].v)
    if (v >= 0) hint_[v] = t;
}

void VoidTriangulation::remove(int t) {
  triangles_[t].is_alive = false;
  free_.push_back(t);
}

void VoidTriangulation::link(int t, int corner, int neighbour) {
  triangles_[t].n[corner] = neighbour;
  if (is_facet(neighbour)) {
    int f = facet_of(neighbour);
    if (f >= static_cast<int>(facet_side_.size())) facet_side_.resize(f + 1);
    facet_side_[f] = {t, corner};
  }
}

void VoidTriangulation::link_both(int t, int corner, int neighbour) {
  link(t, corner, neighbour);
  const auto& v = triangles_[t].v;
  if (neighbour >= 0) link(neighbour, side_between(neighbour, v[(corner + 1) % 3], v[(corner + 2) % 3]), t);
}

int VoidTriangulation::side_between(int t, int a, int b) const {
  const auto& v = triangles_[t].v;
  for (int i = 0; i < 3; ++i) {
    int p = v[(i + 1) % 3], q = v[(i + 2) % 3];
    if ((p == a && q == b) || (p == b && q == a)) return i;
  }
  return -1;
}

// The first triangle of the fan about `node` that `is_wanted`, or -1.
template <class Wanted>
int VoidTriangulation::find_in_fan(int start, int node, Wanted is_wanted) const {
  int t = start;
  do {
    if (is_wanted(t)) return t;
    t = rotate_ccw(t, node);
    if (t == start) return -1;
  } while (t >= 0);
  for (t = rotate_cw(start, node); t >= 0; t = rotate_cw(t, node))
    if (is_wanted(t)) return t;
  return -1;
}

// The one whose wedge at `node` holds the direction to `target`.
int VoidTriangulation::find_towards(int start, int node, Vec2 target) const {
  const Vec2 o = at(node);
  return find_in_fan(start, node, [&](int s) {
    int k = corner_of(s, node);
    const auto& v = triangles_[s].v;
    return orientation(o, at(v[(k + 1) % 3]), target) >= 0 && orientation(o, at(v[(k + 2) % 3]), target) <= 0;
  });
}

Location VoidTriangulation::walk(int start, int node, Vec2 target) const {
  int t = find_towards(start, node, target);
  if (t < 0) return {};
  Vec2 o = at(node);
  int k = corner_of(t, node);
  int u = triangles_[t].v[(k + 1) % 3], w = triangles_[t].v[(k + 2) % 3];
  // The line from o to target passes between u (right) and w (left), out of t opposite corner k.
  for (int left = triangle_count(); left > 0; --left) {
    const auto& v = triangles_[t].v;
    double side[3];
    bool is_inside = true;
    int zeros = 0, zero = -1;
    for (int i = 0; i < 3; ++i) {
      side[i] = orientation(at(v[(i + 1) % 3]), at(v[(i + 2) % 3]), target);
      if (side[i] < 0) is_inside = false;
      if (side[i] == 0) ++zeros, zero = i;
    }
    if (is_inside) {
      if (zeros == 0) return {Location::Kind::inside, t, -1};
      if (zeros == 1) return {Location::Kind::on_side, t, zero};
      for (int i = 0; i < 3; ++i)
        if (side[i] != 0) return {Location::Kind::on_vertex, t, i};
    }
    int next = triangles_[t].n[k];
    if (next < 0) return {Location::Kind::blocked, t, k};
    int j = side_between(next, u, w);
    int z = triangles_[next].v[j];
    bool z_is_left = orientation(o, target, at(z)) > 0;
    k = corner_of(next, z_is_left ? w : u);
    (z_is_left ? w : u) = z;
    t = next;
  }
  return {};
}

bool VoidTriangulation::insert(int node, const Location& where) {
  crossed_.assign(1, where.triangle);
  if (where.kind == Location::Kind::on_side) {
    int other = triangles_[where.triangle].n[where.corner];
    if (other < 0) return false;
    crossed_.push_back(other);
  } else if (where.kind != Location::Kind::inside) {
    return false;
  }
  remove_crossed();
  made_.clear();
  for (const OuterSide& s : outer_) made_.push_back(make(s.a, s.b, node));
  link_cavity();
  stack_ = made_;
  legalise_about(node);
  return true;
}

void VoidTriangulation::divide_side(Side side, const int (&node)[2], const int (&facet)[3]) {
  const VoidTriangle old = triangles_[side.triangle];
  int k = side.corner, z = old.v[k], a = old.v[(k + 1) % 3], b = old.v[(k + 2) % 3];
  outer_ = {{b, z, old.n[(k + 1) % 3]}, {z, a, old.n[(k + 2) % 3]}};
  remove(side.triangle);
  made_ = {make(a, node[0], z), make(node[0], node[1], z), make(node[1], b, z)};
  for (int i = 0; i < 3; ++i) link(made_[i], 2, facet_code(facet[i]));
  link_cavity();
  legalise(made_);
}

// A walk along a line through other vertices may end at a facet between them.
int VoidTriangulation::triangle_at(int node, int start, int near) const {
  const Location at = walk(start, near, this->at(node));
  if (at.kind == Location::Kind::on_vertex && has_node(at.triangle, node)) return at.triangle;
  int t = triangle_count() - 1;
  while (t >= 0 && !(triangles_[t].is_alive && has_node(t, node))) --t;
  return t;
}

// The hole is filled by ears, whatever lies in line with the node.
void VoidTriangulation::erase(int node, int start, int near) {
  const int first = triangle_at(node, start, near);
  std::vector<int> ring;
  crossed_.clear(), outer_.clear(), made_.clear();
  int t = first;
  do {
    if (t < 0) return;  // not in the void, or on its border
    const auto& [v, n, is_alive] = triangles_[t];
    const int k = corner_of(t, node);
    crossed_.push_back(t);
    ring.push_back(v[(k + 1) % 3]);
    outer_.push_back({v[(k + 1) % 3], v[(k + 2) % 3], n[k]});
    t = rotate_ccw(t, node);
  } while (t != first);
  clip_ears(ring);
  for (int c : crossed_) remove(c);
  link_cavity();
  legalise(made_);
}

// Takes out the triangles of crossed_; their sides to others are outer_.
void VoidTriangulation::remove_crossed() {
  auto is_crossed = [&](int n) { return n >= 0 && std::find(crossed_.begin(), crossed_.end(), n) != crossed_.end(); };
  outer_.clear();
  for (int c : crossed_)
    for (int i = 0; i < 3; ++i)
      if (int n = triangles_[c].n[i]; !is_crossed(n))
        outer_.push_back({triangles_[c].v[(i + 1) % 3], triangles_[c].v[(i + 2) % 3], n});
  for (int c : crossed_) remove(c);
}

// Links the triangles of made_ with one another and with the sides in outer_.
void VoidTriangulation::link_cavity() {
  for (int t : made_)
    for (int i = 0; i < 3; ++i) {
      if (triangles_[t].n[i] != -1) continue;
      int a = triangles_[t].v[(i + 1) % 3], b = triangles_[t].v[(i + 2) % 3];
      auto link_to = [&](int s) {
        for (int j = 0; s != t && j < 3; ++j)
          if (triangles_[s].v[(j + 1) % 3] == b && triangles_[s].v[(j + 2) % 3] == a) {
            triangles_[t].n[i] = s;
            triangles_[s].n[j] = t;
            return true;
          }
        return false;
      };
      if (std::ranges::any_of(made_, link_to)) continue;
      for (const OuterSide& o : outer_)
        if (o.a == a && o.b == b) {
          link_both(t, i, o.neighbour);
          break;
        }
    }
}

// Triangulates a counter-clockwise, possibly weakly simple polygon into made_; false when stuck.
bool VoidTriangulation::clip_ears(std::vector<int>& polygon) {
  while (polygon.size() > 3) {
    int m = static_cast<int>(polygon.size()), best = -1;
    double best_shape = -1;
    for (int i = 0; i < m; ++i) {
      int a = polygon[(i + m - 1) % m], b = polygon[i], c = polygon[(i + 1) % m];
      if (a == c) continue;
      Vec2 pa = at(a), pb = at(b), pc = at(c);
      double area = orientation(pa, pb, pc);
      if (area <= 0) continue;
      const double shape = area / (dot(pb - pa, pb - pa) + dot(pc - pb, pc - pb) + dot(pa - pc, pa - pc));
      auto is_in_it = [&](int q) {
        if (q == a || q == b || q == c) return false;
        const Vec2 p = at(q);
        return orientation(pa, pb, p) >= 0 && orientation(pb, pc, p) >= 0 && orientation(pc, pa, p) >= 0;
      };
      if (shape > best_shape && std::ranges::none_of(polygon, is_in_it)) best = i, best_shape = shape;
    }
    if (best < 0) return false;
    made_.push_back(make(polygon[(best + m - 1) % m], polygon[best], polygon[(best + 1) % m]));
    polygon.erase(polygon.begin() + best);
  }
  if (orientation(at(polygon[0]), at(polygon[1]), at(polygon[2])) <= 0) return false;
  made_.push_back(make(polygon[0], polygon[1], polygon[2]));
  return true;
}

bool VoidTriangulation::recover(int start, int a, int b) {
  Vec2 pa = at(a), pb = at(b);
  int t = find_towards(start, a, pb);
  if (t < 0) return false;
  int k = corner_of(t, a);
  int u = triangles_[t].v[(k + 1) % 3], w = triangles_[t].v[(k + 2) % 3];
  if (u == b || w == b) return true;
  if (orientation(pa, at(u), pb) == 0 || orientation(pa, at(w), pb) == 0) return false;
  crossed_.assign(1, t);
  right_.assign({a, u});
  left_.assign({a, w});
  while (true) {
    int next = triangles_[t].n[k];
    if (next < 0) return false;
    int j = side_between(next, u, w);
    int z = triangles_[next].v[j];
    if (static_cast<int>(crossed_.size()) > std::min(most_crossed_, triangle_count())) return false;
    crossed_.push_back(next);
    t = next;
    if (z == b) break;
    double side = orientation(pa, pb, at(z));
    if (side == 0) return false;
    if (side > 0) {
      k = corner_of(next, w);
      left_.push_back(w = z);
    } else {
      k = corner_of(next, u);
      right_.push_back(u = z);
    }
  }
  right_.push_back(b);  // a, right chain, b: counter-clockwise with the closing side b-a
  left_.push_back(b);
  std::reverse(left_.begin(), left_.end());  // b, left chain, a
  made_.clear();
  if (!clip_ears(right_) || !clip_ears(left_)) {
    for (int m : made_) remove(m);
    return false;
  }
  remove_crossed();
  link_cavity();
  spoiled_.insert(spoiled_.end(), made_.begin(), made_.end());
  return true;
}

// Where facets set before divide the fan at a, the sector that sees b must be searched for.
bool VoidTriangulation::recover_from_any(int a, int b) {
  for (int t = 0; t < triangle_count(); ++t)
    if (triangles_[t].is_alive && has_node(t, a) && recover(t, a, b)) return true;
  return false;
}

bool VoidTriangulation::should_flip(int t, int corner) const {
  int other = triangles_[t].n[corner];
  if (other < 0) return false;
  const auto& v = triangles_[t].v;
  int a = v[corner], b = v[(corner + 1) % 3], c = v[(corner + 2) % 3];
  int z = triangles_[other].v[side_between(other, b, c)];
  return in_circle(at(a), at(b), at(c), at(z)) && orientation(at(a), at(b), at(z)) > 0 &&
         orientation(at(a), at(z), at(c)) > 0;
}

void VoidTriangulation::flip(int t, int corner) {
  int other = triangles_[t].n[corner];
  auto v = triangles_[t].v;
  int a = v[corner], b = v[(corner + 1) % 3], c = v[(corner + 2) % 3];
  int j = side_between(other, b, c);
  int z = triangles_[other].v[j];
  int n_ab = triangles_[t].n[(corner + 2) % 3], n_ca = triangles_[t].n[(corner + 1) % 3];
  int n_bz = triangles_[other].n[corner_of(other, c)], n_zc = triangles_[other].n[corner_of(other, b)];
  triangles_[t].v = {a, b, z};
  triangles_[other].v = {a, z, c};
  note(t);
  note(other);
  link_both(t, 0, n_bz);
  link_both(t, 2, n_ab);
  link_both(other, 0, n_zc);
  link_both(other, 1, n_ca);
  triangles_[t].n[1] = other;
  triangles_[other].n[2] = t;
}

void VoidTriangulation::legalise(std::vector<int>& stack) {
  long budget = 1000 + 40 * static_cast<long>(stack.size()) + 4L * triangle_count();  // ends even on a rounding cycle
  while (!stack.empty() && budget > 0) {
    int t = stack.back();
    stack.pop_back();
    if (!triangles_[t].is_alive) continue;
    for (int i = 0; i < 3; ++i) {
      if (!should_flip(t, i)) continue;
      int other = triangles_[t].n[i];
      flip(t, i);
      --budget;
      stack.push_back(t);
      stack.push_back(other);
      break;
    }
  }
  stack.clear();
}

// About a node just inserted only the sides opposite it can be wrong, and no flip about it is undone.
void VoidTriangulation::legalise_about(int node) {
  while (!stack_.empty()) {
    int t = stack_.back(), corner = corner_of(t, node), other = triangles_[t].n[corner];
    stack_.pop_back();
    if (!should_flip(t, corner)) continue;
    flip(t, corner);
    stack_.push_back(t);
    stack_.push_back(other);
  }
}

std::optional<int> VoidTriangulation::insert_all(const std::vector<std::pair<int, int>>& facets) {
  Box box;
  for (auto [a, b] : facets) box.add(points_[a]);
  const auto& [low, high] = box;
  // Far away, and askew: no facet is in line with two of its corners.
  constexpr double away = 64, left = 0.6, right = 0.61, top = 0.02;
  double span = away * std::max(high.x - low.x, high.y - low.y);
  Vec2 centre{0.5 * (low.x + high.x), 0.5 * (low.y + high.y)};
  frame_ = {centre + Vec2{-span, -left * span}, centre + Vec2{span, -right * span}, centre + Vec2{top * span, span}};
  int last = make(-1, -2, -3);
  for (int i = 0; i < 3; ++i) link(last, i, facet_code(static_cast<int>(facets.size()) + i));
  std::vector<int> order;
  for (auto [a, b] : facets) order.push_back(a);
  std::sort(order.begin(), order.end());
  order.erase(std::unique(order.begin(), order.end()), order.end());
  // A fixed stride visits the loops at a coarse spacing first: the walks stay short and the order is always the same.
  auto facet_from = [&](int node) {
    for (std::size_t f = 0; f < facets.size(); ++f)
      if (facets[f].first == node) return static_cast<int>(f);
    return -1;
  };
  std::size_t n = order.size();
  std::vector<bool> is_done(n, false);
  int near = -1;
  for (std::size_t stride = std::size_t{1} << 20; stride >= 1; stride /= 2)
    for (std::size_t i = 0; i < n; i += stride) {
      if (is_done[i]) continue;
      is_done[i] = true;
      if (!insert(order[i], walk(last, near, points_[order[i]]))) return facet_from(order[i]);
      near = order[i];
      last = made_.front();  // flips about the new node keep it a corner
    }
  return std::nullopt;
}

void VoidTriangulation::carve_outside(const std::vector<std::pair<int, int>>& facets) {
  // Facets were set on both sides; what the frame reaches without crossing one is outside.
  std::vector<int> stack;
  for (int t = 0; t < triangle_count(); ++t)
    if (triangles_[t].is_alive &&
        std::any_of(triangles_[t].v.begin(), triangles_[t].v.end(), [](int v) { return v < 0; }))
      stack.push_back(t);
  int count = static_cast<int>(facets.size());
  for (int pass = 0; pass < 2; ++pass) {
    while (!stack.empty()) {
      int t = stack.back();
      stack.pop_back();
      if (!triangles_[t].is_alive) continue;
      remove(t);
      for (int n : triangles_[t].n)
        if (n >= 0) stack.push_back(n);
    }
    // Holes: triangles on the wrong side of a facet.
    for (int t = 0; pass == 0 && t < triangle_count(); ++t)
      if (triangles_[t].is_alive)
        for (int n : triangles_[t].n)
          if (is_facet(n) && facet_of(n) >= count) stack.push_back(t);
  }
  for (int t = 0; t < triangle_count(); ++t)
    if (triangles_[t].is_alive)
      for (int i = 0; i < 3; ++i) link(t, i, triangles_[t].n[i]);
}

// Puts facet f on the left of its side and a stop on the right.
bool VoidTriangulation::bound_facet(int f, int count, std::pair<int, int> ends) {
  auto [a, b] = ends;
  auto try_set = [&, from = a, to = b](int t) {
    int side = side_between(t, from, to);
    if (side < 0 || triangles_[t].v[(side + 1) % 3] != from) return false;
    int other = triangles_[t].n[side];
    link(t, side, facet_code(f));
    if (other >= 0) link(other, side_between(other, from, to), facet_code(count + 3 + f));
    return true;
  };
  if (find_in_fan(hint_[a], a, try_set) >= 0) return true;
  for (int s = 0; s < triangle_count(); ++s)  // another sector of a
    if (triangles_[s].is_alive && has_node(s, a) && try_set(s)) return true;
  return false;
}

std::optional<int> VoidTriangulation::build(const std::vector<std::pair<int, int>>& facets) {
  triangles_.clear(), free_.clear(), spoiled_.clear();
  most_crossed_ = 1 << 30;
  int count = static_cast<int>(facets.size());
  facet_side_.assign(2 * count + 3, Side{});
  hint_.assign(points_.size(), -1);
  if (auto touching = insert_all(facets)) return touching;
  for (int f = 0; f < count; ++f) {
    const int a = facets[f].first, b = facets[f].second;
    if ((!recover(hint_[a], a, b) && !recover_from_any(a, b)) || !bound_facet(f, count, facets[f])) return f;
  }
  hint_.clear();
  carve_outside(facets);
  std::vector<int> all;
  for (int t = 0; t < triangle_count(); ++t)
    if (triangles_[t].is_alive) all.push_back(t);
  legalise(all);
  spoiled_.clear();
  most_crossed_ = 64;
  for (int f = 0; f < count; ++f) {  // another facet may have taken its side
    const auto [t, corner] = facet_side_[f];
    if (t < 0 || !triangles_[t].is_alive || triangles_[t].n[corner] != facet_code(f)) return f;
  }
  return std::nullopt;
}

}  // namespace paver
