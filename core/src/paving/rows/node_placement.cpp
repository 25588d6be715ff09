// Places new nodes by walking in the tangent plane of the parent, with the opposing front in view: where it is less
// than about one and a half steps away the row connects to it, where it is less than two and a half the step is halved.
#include "paving/rows/node_placement.h"

#include <algorithm>

#include "base/predicates.h"
#include "paving/front/facing.h"

namespace paver {
namespace {

constexpr double connect_reach = 1.42;  // of the step: connect to the opposing front instead of a new node
constexpr double halve_reach = 2.45;    // of the step: meet it half way
constexpr double thin_gap = 0.35;       // of the step: in a strip this thin the nearest node does, however oblique
constexpr double least_step = 0.35;     // of the step: shorter new edges are not worth a quad
constexpr double merge_reach = 0.55;    // of the step or of shorter facets: a front node as near to the place is taken
constexpr double least_room =
    0.2;  // of the same: with a node nearer than this, that cannot be taken, nothing is placed
constexpr double chart_share = 0.6;  // of a distance in the chart that counts, for the chart's distortion
constexpr double dearest_end = 2.2,
                 turn_price = 2.5;  // of an end of the facet in the way: (1 - cosine) and log of length
// Of the step: on one surface a longer or shorter one is the chart's fault, where turns count as much is done at a
// time.
constexpr double likely_factor[] = {0.5, 2};
constexpr int most_corrections = 5;                       // where turns count
constexpr double near_enough = 0.05;                      // of the length
constexpr double least_share = 1.0 / 16, most_share = 4;  // of the straight step

/// Chart point at `length` along the wish. One correction for the curvature of the surface; where turns count lengths
/// may change on the way, and several are worth it.
Vec2 chart_point(const Front& front, const Wish& wish, double length) {
  const RegionMesh& mesh = front.mesh;
  const Chart& chart = *front.region.chart;
  Vec2 p = mesh.p[wish.base], step = mesh.pull_back(wish.base, length * wish.direction);
  if (front.region.surface->kind() == SurfaceKind::plane) return p + step;
  const int corrections = mesh.has_turns() ? most_corrections : 1;
  double share = 1;
  for (int i = 0; i < corrections; ++i) {
    const double got = norm(mesh.between(wish.base, front.region.place(chart.walk(p, share * step))));
    const double factor = length / got;
    if (!mesh.has_turns() && !(factor > likely_factor[0] && factor < likely_factor[1])) break;
    share = std::clamp(share * std::clamp(factor, likely_factor[0], likely_factor[1]), least_share, most_share);
    if (!(std::fabs(factor - 1) > near_enough)) break;
  }
  return chart.walk(p, share * step);
}

/// Distance from a node to a point of the surface. Two sides of a cut, or two sheets that pass near one another, are
/// close in space and far in the chart: the longer of the two counts, the chart's with room for its distortion.
double distance(const RegionMesh& mesh, const Chart& chart, int from, Vec2 p, const MetricVec& way) {
  return std::max(norm(way), chart_share * norm(mesh.push(from, chart.step_to(mesh.p[from], p))));
}

/// Distance from the base to the facet in the way; the ray is straight in the chart.
double distance_to_facet(const Front& front, int base, Vec2 far, int a, int b) {
  const RegionMesh& mesh = front.mesh;
  double sa = orientation(mesh.p[base], far, mesh.p[a]), sb = orientation(mesh.p[base], far, mesh.p[b]);
  double t = sa == sb ? 0.5 : sa / (sa - sb);
  return distance(mesh, *front.region.chart, base, (1 - t) * mesh.p[a] + t * mesh.p[b],
                  (1 - t) * mesh.between(base, a) + t * mesh.between(base, b));
}

bool is_allowed(const Front& front, const Wish& wish, int node, int avoid_a, int avoid_b) {
  return node != wish.base && node != avoid_a && node != avoid_b && front.sectors(node) > 0 &&
         front.may_connect(wish.base, node);
}

/// The better end of a facet to connect to: small turn from the wished direction, length near the gap.
int choose_end(const Front& front, const Wish& wish, const Facet& facet, double gap, int avoid_a, int avoid_b) {
  int best = -1;
  bool is_thin = gap < thin_gap * wish.length;
  double best_cost = is_thin ? 1 : dearest_end;
  for (int node : {facet.a, facet.b, front.facets[facet.prev].a, front.facets[facet.next].b}) {
    if (!is_allowed(front, wish, node, avoid_a, avoid_b)) continue;
    const MetricVec v = front.mesh.between(wish.base, node);
    double length = distance(front.mesh, *front.region.chart, wish.base, front.mesh.p[node], v);
    if (!(length > 0)) continue;
    double cosine = dot(v, wish.direction) / length;
    double cost = is_thin ? length / wish.length : turn_price * (1 - cosine) + std::fabs(std::log(length / gap));
    if (cost < best_cost) best_cost = cost, best = node;
  }
  return best;
}

/// A front node near p among the corners of the triangle and of its neighbours.
int near_node(const Front& front, const Wish& wish, int t, const NodePlace& at, int avoid_a, int avoid_b,
              double& nearest) {
  int best = -1;
  double best_distance = merge_reach * std::min(wish.length, wish.width);
  nearest = 1e300;
  auto look = [&](int node) {
    if (front.sectors(node) == 0 || node == wish.base) return;
    double d = distance(front.mesh, *front.region.chart, node, at.p, front.mesh.between(node, at));
    if (node != avoid_a && node != avoid_b) nearest = std::min(nearest, d);
    if (d < best_distance && is_allowed(front, wish, node, avoid_a, avoid_b)) best = node, best_distance = d;
  };
  const VoidTriangle& tri = front.empty.triangle(t);
  for (int i = 0; i < 3; ++i) {
    look(tri.v[i]);
    if (tri.n[i] < 0) continue;
    const VoidTriangle& beyond = front.empty.triangle(tri.n[i]);
    for (int v : beyond.v) look(v);
  }
  return best;
}

}  // namespace

Wish make_wish(const Front& front, int f, double angle, double length) {
  const RegionMesh& mesh = front.mesh;
  int b = front.facets[f].b, c = front.facets[front.facets[f].next].b;
  const MetricFrame frame = mesh.frame(b);
  const Vec2 out = frame.of(mesh.between(b, c));
  const double reach = norm(out);
  const Vec2 ahead = reach > 0 ? (1 / reach) * out : Vec2{}, left{-ahead.y, ahead.x};
  double width = std::max(front.length(f), front.length(front.facets[f].next));
  return {b, frame.at(std::cos(angle) * ahead + std::sin(angle) * left), length, width};
}

Wish make_wide_wish(const Front& front, int f, double length) {
  constexpr int most_facets = 64;
  constexpr double straight = 0.6;  // radians: the stretch ends at corners sharper than this
  const RegionMesh& mesh = front.mesh;
  auto is_straight = [&](int g) { return std::fabs(front.chord_angle_after(g) - M_PI) < straight; };
  int first = f, last = front.facets[f].next;
  double back = front.length(first), ahead = front.length(last);
  for (int i = 0; i < most_facets && back < 0.5 * length && is_straight(front.facets[first].prev); ++i)
    back += front.length(first = front.facets[first].prev);
  for (int i = 0; i < most_facets && ahead < 0.5 * length && is_straight(last); ++i)
    ahead += front.length(last = front.facets[last].next);
  int b = front.facets[f].b;
  // Each half counts the same, however far it reaches.
  const MetricFrame frame = mesh.frame(b);
  const Vec2 along =
      frame.of(unit(mesh.between(front.facets[first].a, b))) + frame.of(unit(mesh.between(b, front.facets[last].b)));
  Wish wish = make_wish(front, f, M_PI / 2, length);
  wish.direction = unit(frame.at({-along.y, along.x}));
  return wish;
}

Granted grant(Front& front, const Wish& wish, int start, int avoid_a, int avoid_b) {
  RegionMesh& mesh = front.mesh;
  double length = wish.length;
  Vec2 far = chart_point(front, wish, halve_reach * length);
  Location seen = front.empty.walk(start, wish.base, far);
  if (seen.triangle < 0) return {};
  if (seen.kind == Location::Kind::blocked) {
    const Facet& facet = front.facets[facet_of(front.empty.triangle(seen.triangle).n[seen.corner])];
    double gap = distance_to_facet(front, wish.base, far, facet.a, facet.b);
    if (gap < connect_reach * length) {
      int node = choose_end(front, wish, facet, gap, avoid_a, avoid_b);
      const bool leans = facet.b == avoid_a;  // over the base, the side that the row laid last
      if (leans && !wish.is_turned && node >= 0 && norm(mesh.between(wish.base, node)) > connect_reach * length) {
        Wish beside = wish;
        beside.direction = unit(mesh.between(facet.b, facet.a));
        beside.is_turned = true;
        return grant(front, beside, start, avoid_a, avoid_b);
      }
      if (node >= 0) return {node, false};
      if (gap < 2 * least_step * length) return {};
      length = 0.5 * gap;
    } else {
      length = std::min(length, 0.5 * gap);
    }
  }
  Vec2 p = chart_point(front, wish, length);
  Location where = front.empty.walk(start, wish.base, p);
  if (where.triangle < 0 || where.kind == Location::Kind::blocked) return {};
  if (where.kind == Location::Kind::on_vertex) {
    int node = front.empty.triangle(where.triangle).v[where.corner];
    return is_allowed(front, wish, node, avoid_a, avoid_b) ? Granted{node, false} : Granted{};
  }
  const NodePlace at = front.region.place(p);
  if (is_beyond_facet(front, where.triangle, at)) return {};
  double nearest;
  int node = near_node(front, wish, where.triangle, at, avoid_a, avoid_b, nearest);
  if (node >= 0) return {node, false};
  if (nearest < least_room * std::min(wish.length, wish.width)) return {};
  int fresh = front.add_placed_node(at);
  mesh.h[fresh] = std::min(mesh.h[fresh], mesh.h[wish.base] + front.region.gradation * length);
  return {fresh, true};
}

}  // namespace paver
