// Edits of the front. Every edit is checked first and then carried out whole, so the void triangulation, the facets
// and the mesh agree at all times, and every element is positive in the chart when it is made.
#include "paving/front/front.h"

#include <algorithm>
#include <numeric>

#include "base/predicates.h"
#include "mesh/spatial_order.h"
#include "paving/closing/acute_corners.h"
#include "paving/closing/closed_tube_rows.h"
#include "paving/closing/fan_rings.h"
#include "paving/closing/gap_rows.h"
#include "paving/closing/hole_rings.h"
#include "paving/closing/rounded_corners.h"
#include "paving/closing/tube_rows.h"
#include "paving/front/loop_node.h"
#include "paving/front/wide_corners.h"
#include "regions/crossing_facets.h"

namespace paver {

constexpr double expected = 1.1, most_expected = 5e7;  // elements, the first by area / h^2
constexpr double up_of_tuck = 0.45;                    // of the quad behind a divided facet

/// A new element about to be made: corners, and per side the facet it uses up or the triangle behind it.
struct Front::Outline {
  int count = 0;
  int corner[4] = {-1, -1, -1, -1};
  int triangle[2] = {-1, -1};
  Side behind[4];  // void side behind each element side that is not a facet
  int facet[4] = {-1, -1, -1, -1};
  int entering[4] = {-1, -1, -1, -1};  // where both sides at a corner are new: facets of the sector it divides
  int leaving[4] = {-1, -1, -1, -1};
};

Front::Front(const Region& r, RegionMesh& m) : region(r), mesh(m), empty(m.p) {
  if (mesh.p.empty()) mesh.turn_weight = region.size.turn_weight();
}

void Front::add_start_loop(const std::vector<int>& nodes) {
  int base = static_cast<int>(facets.size()), count = static_cast<int>(nodes.size());
  for (int i = 0; i < count; ++i)
    facets.push_back(
        {nodes[i], nodes[(i + 1) % count], base + (i + 1) % count, base + (i + count - 1) % count, 0, true});
}

int Front::add_boundary_node(const std::vector<LoopNode>& loop, std::size_t i) {
  const std::size_t n = loop.size();
  const Vec2 next = loop[(i + 1) % n].p, before = loop[(i + n - 1) % n].p;
  int node = add_loop_node(region, loop[i], 0.5 * (next + before), true, mesh);
  take_clear_tangents(region, node, next - before, mesh);
  at_node_.resize(node + 1);
  return node;
}

void Front::note_boundary(const std::vector<std::vector<int>>& loops) {
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0, n = loops[l].size(); i < n; ++i)
      boundary.push_back({loops[l][i], loops[l][(i + 1) % n], region.loops[l][i].edge, region.loops[l][i].angle});
}

std::optional<int> Front::start_at(const std::vector<std::vector<int>>& loops) {
  note_boundary(find_loop_nodes(region, mesh));
  for (const std::vector<int>& nodes : loops) add_start_loop(nodes);
  return open_void();
}

// It has no normal: for elements about it the mean of the normals there is one.
void Front::set_apex(int centre, const std::vector<int>& ring) {
  Vec3 mean;
  for (int node : ring) mean += mesh.normal(node);
  mean = unit(mean);
  const Vec3 along = mesh.x[ring[0]] - mesh.x[centre];
  mesh.xp[centre] = norm(mesh.xp[centre]) * unit(along - dot(along, mean) * mean);
  mesh.xq[centre] = norm(mesh.xq[centre]) * cross(mean, unit(mesh.xp[centre]));
  mesh.turn[centre].n = {};
}

std::optional<int> Front::start(std::optional<double> sharpest_corner) {
  // About as many as a uniform mesh has: growing by doubling would take half as much memory again.
  mesh.reserve(static_cast<std::size_t>(std::min(expected * region.area / (region.h * region.h), most_expected)));
  std::vector<std::vector<int>> loops = number_loop_nodes(region).of_loop;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<LoopNode>& loop = region.loops[l];
    const std::vector<int>& nodes = loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (nodes[i] == mesh.node_count()) add_boundary_node(loop, i);
  }
  note_boundary(loops);
  const std::vector<Vec2> places = mesh.p;
  for (std::size_t l = 0; sharpest_corner && l < loops.size(); ++l) {
    std::vector<LoopNode> loop = region.loops[l];
    lay_rounded_corners(region, mesh, loop, loops[l], places);
    lay_acute_corners(region, mesh, loop, loops[l], places, *sharpest_corner);
  }
  if (sharpest_corner) loops = lay_gap_rows(region, mesh, std::move(loops), *sharpest_corner > 0);
  auto left = lay_closed_tube_rows(region, mesh, lay_tube_rows(region, mesh, loops));
  std::vector<std::size_t> all(left.size());
  std::iota(all.begin(), all.end(), 0);
  lay_hole_rings(region, mesh, left, all);
  for (const std::vector<int>& loop : left) add_start_loop(loop);
  for (const Fan& fan : region.fans) {
    int centre = add_loop_node(region, fan.centre, fan.ring[0].p, true, mesh);
    std::vector<int> ring;
    for (const LoopNode& node : fan.ring) ring.push_back(add_loop_node(region, node, fan.centre.p, false, mesh));
    for (std::size_t i = 0; i < ring.size(); i += 2)
      mesh.add_element({centre, ring[i], ring[i + 1], ring[(i + 2) % ring.size()]});
    if (fan.is_apex) {
      if (mesh.has_turns()) set_apex(centre, ring);
      ring = lay_fan_rings(region, mesh, fan, std::move(ring));
    }
    add_start_loop({ring.rbegin(), ring.rend()});
  }
  std::optional<int> crossing = open_void();
  if (!crossing) find_passed_corners(loops);
  return crossing;
}

void Front::find_passed_corners(const std::vector<std::vector<int>>& loops) {
  for (const std::vector<int>& loop : loops) {
    std::vector<double> angles;
    for (int node : loop) {
      const int f = facet_from(node);
      angles.push_back(f < 0 ? M_PI : angle_after(facets[f].prev));
    }
    for (std::size_t i : passed_corners(angles)) at_node_[loop[i]].is_passed = true;
  }
}

void Front::start_whole() {
  at_node_.assign(mesh.node_count(), {});
  true_angle_.assign(mesh.node_count(), -1);
  for (auto facet = boundary.rbegin(); facet != boundary.rend(); ++facet)  // where loops touch the first one counts
    if (facet->a >= 0) true_angle_[facet->a] = facet->angle;
}

std::optional<int> Front::open_void() {
  start_whole();
  std::vector<std::pair<int, int>> ends;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    ends.push_back({facets[f].a, facets[f].b});
    note_start(static_cast<int>(f));
  }
  auto crossing = empty.build(ends);
  if (!crossing) link_sectors();
  return crossing;
}

// Where loops touch in a node the void about it decides which facet follows which.
void Front::link_sectors() {
  for (int f = 0, n = static_cast<int>(facets.size()); f < n; ++f) {
    int w = facets[f].b;
    if (sectors(w) < 2) continue;
    int t = empty.facet_side(f).triangle;
    while (t >= 0) t = empty.rotate_cw(t, w);
    join(f, facet_of(t));
  }
}

int Front::add_node(Vec2 p) { return add_placed_node(region.place(p)); }

int Front::add_placed_node(const NodePlace& at) {
  at_node_.emplace_back();
  return mesh.add_node(at, region.target(at.p));
}

void Front::drop_last_node() {
  mesh.drop_last_node();
  at_node_.pop_back();
}

double Front::angle_after(int f) const {
  int b = facets[f].b;
  double chords = chord_angle_after(f);
  bool is_boundary = b < static_cast<int>(true_angle_.size()) && true_angle_[b] >= 0 && mesh.star[b].size() == 0;
  if (!is_boundary || sectors(b) != 1) return chords;
  double angle = true_angle_[b];
  if (angle - chords > M_PI) angle -= 2 * M_PI;
  if (chords - angle > M_PI) angle += 2 * M_PI;
  return angle;
}

double Front::chord_angle_after(int f) const {
  int a = facets[f].a, b = facets[f].b, c = facets[facets[f].next].b;
  const MetricFrame frame = mesh.frame(b);
  const Vec2 out = frame.of(mesh.between(b, c)), in = frame.of(mesh.between(b, a));
  double angle = std::atan2(cross(out, in), dot(out, in));
  if (angle < 0) angle += 2 * M_PI;
  constexpr double clear = 0.8;
  if (angle > clear && angle < 2 * M_PI - clear) return angle;
  // The chart settles on which side of a full turn a nearly closed angle is.
  Vec2 o = mesh.p[c] - mesh.p[b], i = mesh.p[a] - mesh.p[b];
  double flat = std::atan2(cross(o, i), dot(o, i));
  if (flat < 0 || (flat == 0 && a != c)) flat += 2 * M_PI;
  if (angle - flat > M_PI) angle -= 2 * M_PI;
  if (flat - angle > M_PI) angle += 2 * M_PI;
  return angle;
}

void Front::collect_loop(int f, std::vector<int>& loop) const {
  loop.clear();
  each_of_loop(f, [&](int g) { loop.push_back(g); });
}

Front::Colour Front::root(Colour c) const {
  while (parent_[c.set].set != c.set) {
    Colour& up = parent_[c.set];
    const Colour above = parent_[up.set];
    up = {above.set, up.bit != above.bit};  // halves the path for the next one who asks
    c = {up.set, c.bit != up.bit};
  }
  return c;
}

Front::Colour Front::root(int node) const {
  const Colour own = at_node_[node].colour;
  return own.set < 0 ? own : root(own);
}

bool Front::may_connect(int a, int b) const {
  const Colour ca = root(a), cb = root(b);
  return ca.set < 0 || ca.set != cb.set || ca.bit != cb.bit;
}

// Records that a and b are joined by a mesh edge: they get opposite colours.
void Front::unite(int a, int b) {
  Colour &ca = at_node_[a].colour, &cb = at_node_[b].colour;
  if (ca.set < 0 && cb.set < 0) return;
  if (ca.set < 0) {
    ca = {cb.set, !cb.bit};
  } else if (cb.set < 0) {
    cb = {ca.set, !ca.bit};
  } else {
    Colour ra = root(ca), rb = root(cb);
    if (ra.set != rb.set) parent_[rb.set] = {ra.set, ra.bit == rb.bit};
  }
}

void Front::colour_loop(int f) {
  int set = static_cast<int>(parent_.size());
  parent_.push_back({set, false});
  bool bit = false;
  each_of_loop(f, [&](int g) {
    Colour& colour = at_node_[facets[g].a].colour;
    if (colour.set >= 0) {  // shared with a loop coloured before
      Colour other = root(colour), own = root({set, bit});
      if (other.set != own.set) parent_[own.set] = {other.set, other.bit != own.bit};
    } else {
      colour = {set, bit};
    }
    bit = !bit;
  });
}

int Front::add_facet(int a, int b, int level) {
  int f = static_cast<int>(facets.size());
  facets.push_back({a, b, -1, -1, level, true});
  note_start(f);
  return f;
}

void Front::note_start(int f) {
  NodeOnFront& start = at_node_[facets[f].a];
  start.out_facet = f;
  ++start.sectors;
}

void Front::kill(int f) {
  facets[f].is_alive = false;
  NodeOnFront& start = at_node_[facets[f].a];
  --start.sectors;
  if (start.out_facet != f) return;
  start.out_facet = start.sectors > 0 ? newest_facet(facets[f].a) : -1;  // rare: several sectors meet here
}

int Front::newest_facet(int from) const {
  for (int f = static_cast<int>(facets.size()) - 1; f >= 0; --f)
    if (facets[f].is_alive && (from < 0 || facets[f].a == from)) return f;
  return -1;
}

void Front::join(int prev, int next) {
  facets[prev].next = next;
  facets[next].prev = prev;
}

bool Front::colours_allow(const Outline& o) {
  if (o.count == 3) return true;
  for (int i = 0; i < 4; ++i)
    if (o.facet[i] < 0 && !may_connect(o.corner[i], o.corner[(i + 1) % 4])) return false;
  // Two of the new sides may join the same two loops: then the path between must fit, too.
  for (int i = 0; i < 4; ++i) {
    const Colour ca = root(o.corner[i]), cb = root(o.corner[(i + 2) % 4]);
    if (ca.set >= 0 && ca.set == cb.set && ca.bit != cb.bit) return false;
  }
  return true;
}

// Makes the sides of the element and finds the one or two triangles it consists of.
bool Front::find_outline(int f, int c, int d, Outline& o) {
  int a = facets[f].a, b = facets[f].b;
  o.count = d < 0 ? 3 : 4;
  o.corner[0] = a, o.corner[1] = b, o.corner[2] = c, o.corner[3] = d;
  if (!empty.recover(empty.facet_side(f).triangle, b, c)) return false;
  if (!empty.recover(empty.facet_side(f).triangle, a, d < 0 ? c : d)) return false;
  int t = empty.facet_side(f).triangle;
  o.triangle[0] = t;
  if (o.count == 4) {
    int s = t;  // the triangle left of b -> c
    for (int guard = 0; s >= 0; s = empty.rotate_cw(s, b)) {
      if (empty.triangle(s).v[(empty.corner_of(s, b) + 1) % 3] == c) break;
      if (++guard > 1000) return false;
    }
    if (s < 0 || !empty.recover(s, c, d)) return false;
    t = o.triangle[0] = empty.facet_side(f).triangle;
    int apex = empty.triangle(t).v[empty.facet_side(f).corner];
    if (apex != c && apex != d) return false;
    int across = empty.triangle(t).n[empty.corner_of(t, apex == c ? b : a)];
    if (across < 0) return false;
    o.triangle[1] = across;
    int far = empty.triangle(across).v[empty.side_between(across, apex, apex == c ? a : b)];
    if (far != (apex == c ? d : c)) return false;
  } else if (empty.triangle(t).v[empty.facet_side(f).corner] != c) {
    return false;
  }
  for (int i = 0; i < o.count; ++i) {
    int u = o.corner[i], w = o.corner[(i + 1) % o.count];
    int in = empty.side_between(o.triangle[0], u, w) >= 0 ? o.triangle[0] : o.triangle[1];
    int n = empty.triangle(in).n[empty.side_between(in, u, w)];
    if (is_facet(n)) {
      o.facet[i] = facet_of(n);
    } else {
      o.behind[i] = {n, empty.side_between(n, u, w)};
    }
  }
  for (int i = 0; i < o.count; ++i) {
    int before = (i + o.count - 1) % o.count, w = o.corner[i];
    if (o.facet[i] >= 0 || o.facet[before] >= 0 || sectors(w) == 0) continue;
    int s = o.behind[before].triangle;
    while (s >= 0) s = empty.rotate_ccw(s, w);
    o.entering[i] = facet_of(s);
    s = o.behind[i].triangle;
    while (s >= 0) s = empty.rotate_cw(s, w);
    o.leaving[i] = facet_of(s);
  }
  return true;
}

void Front::relink(const Outline& o, int level) {
  int fresh[4] = {-1, -1, -1, -1};
  int n = o.count;
  empty.remove(o.triangle[0]);
  if (n == 4) empty.remove(o.triangle[1]);
  for (int i = 0; i < n; ++i) {
    if (o.facet[i] >= 0) continue;
    int u = o.corner[i], w = o.corner[(i + 1) % n];
    if (n == 4) unite(u, w);
    fresh[i] = add_facet(w, u, level);
    empty.set_facet(o.behind[i], fresh[i]);
  }
  for (int i = 0; i < n; ++i) {
    int in = (i + n - 1) % n;
    if (o.facet[in] >= 0 && o.facet[i] >= 0) continue;  // the sector is used up
    if (o.facet[in] >= 0) {
      join(fresh[i], facets[o.facet[in]].next);
    } else if (o.facet[i] >= 0) {
      join(facets[o.facet[i]].prev, fresh[in]);
    } else if (o.entering[i] >= 0) {
      join(o.entering[i], fresh[in]);
      join(fresh[i], o.leaving[i]);
    } else {
      join(fresh[i], fresh[in]);
    }
  }
  for (int i = 0; i < n; ++i)
    if (o.facet[i] >= 0) kill(o.facet[i]);
  empty.legalise_recovered();
}

bool Front::form_element(int f, int c, int d, int level) {
  Outline o;
  int a = facets[f].a, b = facets[f].b;
  bool is_simple = c != a && c != b && d != a && d != b && c != d;
  if (!is_simple) return false;
  if (!find_outline(f, c, d, o) || !colours_allow(o)) {
    empty.legalise_recovered();
    return false;
  }
  mesh.add_element({a, b, c, d});
  relink(o, level);
  return true;
}

namespace {

bool element_stays_positive(const RegionMesh& mesh, const Element& e, int node, Vec2 p) {
  int n = e.corners(), k = e.corner_of(node);
  auto at = [&](int i) { return e.v[i % n] == node ? p : mesh.p[e.v[i % n]]; };
  for (int i = 0; i < n; ++i) {
    if (n == 4 && i == 2) continue;  // the far corner does not see the node
    int j = k + i + n;
    if (orientation(at(j - 1), at(j), at(j + 1)) <= 0) return false;
  }
  return true;
}

}  // namespace

bool Front::can_move(int node, Vec2 p) const {
  for (int e : mesh.star[node])
    if (!element_stays_positive(mesh, mesh.elements[e], node, p)) return false;
  if (sectors(node) > 1) return false;
  if (sectors(node) == 0) return true;
  for (int t = empty.facet_side(facet_from(node)).triangle; t >= 0; t = empty.rotate_ccw(t, node)) {
    int k = empty.corner_of(t, node);
    const auto& v = empty.triangle(t).v;
    if (orientation(p, mesh.p[v[(k + 1) % 3]], mesh.p[v[(k + 2) % 3]]) <= 0) return false;
  }
  return true;
}

void Front::renew_void(const std::vector<int>& nodes) {
  stack_.clear();
  for (int node : nodes)
    if (sectors(node) > 0) collect_fan(facet_from(node), stack_);
  empty.legalise(stack_);
}

void Front::slide(int node, Vec2 p, double scale) {
  const Vec2 by = p - mesh.p[node];
  mesh.drift[node] += static_cast<float>(norm(mesh.push(node, by)) / scale);
  if (mesh.drift[node] > most_drift) {
    mesh.put(node, region.place(p));
    return;
  }
  mesh.p[node] = p;
  mesh.x[node] += by.x * mesh.xp[node] + by.y * mesh.xq[node];
  if (mesh.has_turns()) mesh.turn[node].n += by.x * mesh.turn[node].np + by.y * mesh.turn[node].nq;
}

void Front::end_slides() {
  for (int i = 0; i < mesh.node_count(); ++i) {
    if (!(mesh.drift[i] > 0) || mesh.star[i].size() == 0) continue;
    mesh.put(i, region.place(mesh.p[i]));
  }
}

void Front::end_void() {
  facets = std::vector<Facet>();
  empty.clear();
  true_angle_ = std::vector<double>();
}

void Front::order_nodes() {
  if (mesh.node_count() < fewest_to_order) return;
  const std::vector<int> number = order_spatially(mesh);
  for (BoundaryFacet& facet : boundary) facet.a = number[facet.a], facet.b = number[facet.b];
  at_node_.assign(number.size(), {});
}

bool Front::is_alone(int f, int size) const {
  // Without other loops in it the void of n facets has n - 2 triangles; any other loop adds at least its own number.
  std::vector<int> found{empty.facet_side(f).triangle};
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (static_cast<int>(found.size()) > size - 2) return false;
    for (int n : empty.triangle(found[i]).n)
      if (n >= 0 && std::find(found.begin(), found.end(), n) == found.end()) found.push_back(n);
  }
  return static_cast<int>(found.size()) == size - 2;
}

std::vector<Corners> Front::take_void(int f) {
  std::vector<int> stack{empty.facet_side(f).triangle};
  std::vector<Corners> taken;
  while (!stack.empty()) {
    int t = stack.back();
    stack.pop_back();
    const VoidTriangle tri = empty.triangle(t);
    if (!tri.is_alive) continue;
    empty.remove(t);
    taken.push_back({tri.v[0], tri.v[1], tri.v[2], -1});
    for (int n : tri.n) {
      if (n >= 0) stack.push_back(n);
      if (is_facet(n)) kill(facet_of(n));
    }
  }
  return taken;
}

// The void triangles in the sector between facet f and its predecessor, about f's start node.
void Front::collect_fan(int f, std::vector<int>& fan) const {
  for (int t = empty.facet_side(f).triangle; t >= 0; t = empty.rotate_ccw(t, facets[f].a)) fan.push_back(t);
}

bool Front::close_seam(int f, Vec2 p) {
  int g = facets[f].next, a = facets[f].a, b = facets[f].b, c = facets[g].b;
  if (sectors(a) != 1 || sectors(c) != 1) return false;
  int keep = mesh.is_fixed[c] ? c : a, gone = keep == a ? c : a;
  int before = facets[f].prev, after = facets[g].next;
  auto refuse = [&] {
    stack_.assign(1, empty.facet_side(f).triangle);
    empty.legalise(stack_);
    return false;
  };
  if (!empty.recover(empty.facet_side(f).triangle, a, c)) return refuse();
  int inner = empty.facet_side(f).triangle;
  if (empty.triangle(inner).v[empty.facet_side(f).corner] != c) return refuse();
  int outer = empty.triangle(inner).n[empty.corner_of(inner, b)];
  if (outer < 0) return refuse();
  int to_c = empty.triangle(outer).n[empty.corner_of(outer, a)],
      to_a = empty.triangle(outer).n[empty.corner_of(outer, c)];
  if (to_c < 0 && to_a < 0) return refuse();
  std::vector<int> fan;
  collect_fan(f, fan);
  collect_fan(after, fan);
  for (int t : fan) {
    if (t == inner || t == outer) continue;
    const auto& v = empty.triangle(t).v;
    auto at = [&](int i) { return v[i] == a || v[i] == c ? p : mesh.p[v[i]]; };
    if (orientation(at(0), at(1), at(2)) <= 0) return refuse();
  }
  for (int node : {a, c})
    for (int e : mesh.star[node])
      if (!element_stays_positive(mesh, mesh.elements[e], node, p)) return refuse();
  // Carry out.
  int z = empty.triangle(outer).v[empty.side_between(outer, a, c)];
  Side side_c{to_c, to_c >= 0 ? empty.side_between(to_c, c, z) : 0},
      side_a{to_a, to_a >= 0 ? empty.side_between(to_a, a, z) : 0};
  for (int t : fan)
    if (t != inner && t != outer && empty.has_node(t, gone)) empty.replace_node(t, gone, keep);
  if (to_c >= 0) empty.link(side_c.triangle, side_c.corner, to_a);
  if (to_a >= 0) empty.link(side_a.triangle, side_a.corner, to_c);
  empty.remove(inner);
  empty.remove(outer);
  kill(f);
  kill(g);
  facets[before].b = facets[after].a = keep;
  join(before, after);
  at_node_[gone].sectors = 0, at_node_[gone].out_facet = -1;
  at_node_[keep].sectors = 1, at_node_[keep].out_facet = after;
  while (mesh.star[gone].size() > 0) mesh.replace_node(*mesh.star[gone].begin(), gone, keep);
  mesh.h[keep] = 0.5 * (mesh.h[keep] + mesh.h[gone]);
  if (!mesh.is_fixed[keep]) mesh.put(keep, region.place(p));
  stack_.clear();
  for (int t : fan)
    if (t != inner && t != outer) stack_.push_back(t);
  empty.legalise(stack_);
  return true;
}

//   r-----------s        r-----------s
//   |           |        |\\         /|
//   |           |   ->   | n1-----n2 |
//   |           |        | |       | |
//   b <---f---- a        b-m1-----m2-a      (the void is below)
int Front::divide_facet(int f) {
  const Facet old = facets[f];
  const int a = old.a, b = old.b, behind = mesh.across(a, b);
  if (behind < 0 || mesh.elements[behind].corners() != 4) return -1;
  int s = mesh.elements[behind].after(a), r = mesh.elements[behind].before(b);
  Vec2 pa = mesh.p[a], pb = mesh.p[b], ps = mesh.p[s], pr = mesh.p[r];
  auto inside = [&](double along, double up) {
    return (1 - up) * ((1 - along) * pb + along * pa) + up * ((1 - along) * pr + along * ps);
  };
  int m1 = add_node(inside(1.0 / 3, 0)), m2 = add_node(inside(2.0 / 3, 0));
  int n1 = add_node(inside(1.0 / 3, up_of_tuck)), n2 = add_node(inside(2.0 / 3, up_of_tuck));
  const Corners quads[4] = {{b, m1, n1, r}, {m1, m2, n2, n1}, {m2, a, s, n2}, {n1, n2, s, r}};
  Side side = empty.facet_side(f);
  int z = empty.triangle(side.triangle).v[side.corner];
  bool is_fit = orientation(pa, mesh.p[m2], mesh.p[z]) > 0 && orientation(mesh.p[m2], mesh.p[m1], mesh.p[z]) > 0 &&
                orientation(mesh.p[m1], pb, mesh.p[z]) > 0;
  for (const auto& q : quads)
    for (int i = 0; i < 4; ++i)
      is_fit = is_fit && orientation(mesh.p[q[i]], mesh.p[q[(i + 1) % 4]], mesh.p[q[(i + 2) % 4]]) > 0;
  if (!is_fit) {
    for (int i = 0; i < 4; ++i) drop_last_node();
    return -1;
  }
  mesh.remove_element(behind);
  for (const auto& q : quads) mesh.add_element(q);
  double h = mesh.length(a, b) / 3;
  for (int node : {m1, m2, n1, n2})
    mesh.h[node] = std::min(mesh.h[node], std::max(h, 0.5 * std::min(mesh.h[a], mesh.h[b])));
  unite(a, m2), unite(m2, m1), unite(m1, n1), unite(n1, n2);
  int before = old.prev, after = old.next;
  kill(f);
  int f1 = add_facet(a, m2, old.level), f2 = add_facet(m2, m1, old.level), f3 = add_facet(m1, b, old.level);
  join(before == f ? f3 : before, f1), join(f1, f2), join(f2, f3), join(f3, after == f ? f1 : after);
  const int between[2] = {m2, m1}, fresh[3] = {f1, f2, f3};
  empty.divide_side(side, between, fresh);
  return f1;
}

}  // namespace paver
