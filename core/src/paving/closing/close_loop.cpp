// Closures by enumeration of the few patterns a small loop allows, and the closing by triangulation.
#include "paving/closing/close_loop.h"

#include <algorithm>

#include "base/predicates.h"

namespace paver {
namespace {

constexpr double good_enough = 0.45;      // worst value a pattern of a loop of 6 or 8 must reach while rows could go on
constexpr double good_enough_six = 0.03;  // the same of a loop of 6
constexpr double least_quad = 0.02;       // worst value of a loop of four that becomes a quad, not two triangles
constexpr double length_price = 0.25, fair_length = 0.25;  // of the logarithm of length by target length
constexpr double flat_height = 0.4;                        // of the longest way from a loop to its middle
constexpr double fair_quad = 0.2;                          // pairs of triangles merge above this scaled Jacobian

double length_penalty(const RegionMesh& mesh, int a, int b) {
  double ratio = mesh.relative_length(a, b);
  return ratio > 0 ? length_price * std::max(0.0, std::fabs(std::log(ratio)) - fair_length) : 1;
}

/// Best dissection of the polygon into quads by diagonals: worst value, and the quads as positions in the polygon.
struct Dissection {
  double worst = -1;
  std::vector<Corners> quads;
};

Dissection dissect(const RegionMesh& mesh, const std::vector<int>& polygon, const std::vector<int>& at) {
  int n = static_cast<int>(at.size());
  if (n == 4) {
    return {positive_jacobian(mesh, {polygon[at[0]], polygon[at[1]], polygon[at[2]], polygon[at[3]]}),
            {{at[0], at[1], at[2], at[3]}}};
  }
  // The quad on side at[0] - at[1] with its further corners at odd distance.
  Dissection best;
  for (int i = 2; i < n; ++i)
    for (int j = i + 1; j < n; j += 2) {
      if (i % 2 == 1) continue;  // keeps all three remainders even
      double worst = positive_jacobian(mesh, {polygon[at[0]], polygon[at[1]], polygon[at[i]], polygon[at[j]]});
      if (worst <= best.worst) continue;
      Dissection whole{worst, {{at[0], at[1], at[i], at[j]}}};
      auto part = [&](int from, int to) {  // polygon at[from..to], closed by the side to - from
        int count = (to - from + n) % n + 1;
        if (count <= 2) return;
        std::vector<int> sub;
        for (int k = 0; k < count; ++k) sub.push_back(at[(from + k) % n]);
        whole.worst -= length_penalty(mesh, polygon[at[from]], polygon[at[to]]);
        Dissection d = dissect(mesh, polygon, sub);
        whole.worst = std::min(whole.worst, d.worst);
        whole.quads.insert(whole.quads.end(), d.quads.begin(), d.quads.end());
      };
      part(1, i);
      part(i, j);
      part(j, 0);
      if (whole.worst > best.worst) best = std::move(whole);
    }
  return best;
}

/// Star about a new node: quads (v[k], v[k+1], v[k+2], centre) for k = offset, offset + 2, ...
double star_value(Front& front, const std::vector<int>& polygon, int centre, int offset) {
  int n = static_cast<int>(polygon.size());
  double worst = 2;
  for (int k = offset; k < n + offset; k += 2) {
    int a = polygon[k % n], b = polygon[(k + 1) % n], c = polygon[(k + 2) % n];
    worst = std::min(worst, positive_jacobian(front.mesh, {a, b, c, centre}) - length_penalty(front.mesh, a, centre));
  }
  return worst;
}

/// Makes the quads of a dissection, outer ones first so that every quad has a facet when its turn comes.
bool form_dissection(Front& front, const std::vector<int>& loop, const std::vector<int>& polygon, Dissection& d) {
  int level = front.facets[loop[0]].level + 1;
  while (!d.quads.empty()) {
    bool is_made = false;
    for (std::size_t q = 0; q < d.quads.size() && !is_made; ++q)
      for (int i = 0; i < 4 && !is_made; ++i) {
        int a = d.quads[q][i];
        int f = loop[a];
        if (!front.facets[f].is_alive || (a + 1) % static_cast<int>(loop.size()) != d.quads[q][(i + 1) % 4]) continue;
        if (!front.form_element(f, polygon[d.quads[q][(i + 2) % 4]], polygon[d.quads[q][(i + 3) % 4]], level))
          return false;
        d.quads.erase(d.quads.begin() + static_cast<long>(q));
        is_made = true;
      }
    if (!is_made) return false;
  }
  return true;
}

bool close_quad(Front& front, const std::vector<int>& loop, const std::vector<int>& v) {
  int level = front.facets[loop[0]].level + 1;
  if (positive_jacobian(front.mesh, {v[0], v[1], v[2], v[3]}) > least_quad &&
      front.form_element(loop[0], v[2], v[3], level))
    return true;
  // Concave or flat: two triangles over the diagonal that splits it.
  for (int i : {0, 1}) {
    int a = v[i], b = v[i + 1], c = v[i + 2], d = v[(i + 3) % 4];
    const auto& p = front.mesh.p;
    if (orientation(p[a], p[b], p[c]) <= 0 || orientation(p[a], p[c], p[d]) <= 0) continue;
    if (!front.form_element(loop[i], c, -1, level)) continue;
    front.form_element(loop[i + 2], d, -1, level);
    return true;
  }
  return false;
}

bool close_star(Front& front, const std::vector<int>& loop, const std::vector<int>& v, double to_beat) {
  Vec2 p{0, 0};
  double h = 0;
  int n = static_cast<int>(v.size());
  for (int node : v) p = p + (1.0 / n) * front.mesh.p[node], h += front.mesh.h[node] / n;
  Location where = front.empty.walk(front.empty.facet_side(loop[0]).triangle, v[0], p);
  if (where.kind != Location::Kind::inside && where.kind != Location::Kind::on_side) return false;
  int centre = front.add_node(p);
  front.mesh.h[centre] = std::min(h, front.mesh.h[centre]);
  double even = star_value(front, v, centre, 0), odd = star_value(front, v, centre, 1);
  if (std::max(even, odd) <= to_beat || !front.empty.insert(centre, where)) return false;
  int offset = even >= odd ? 0 : 1, level = front.facets[loop[0]].level + 1;
  for (int k = offset; k < n + offset; k += 2)
    if (!front.form_element(loop[k % n], v[(k + 2) % n], centre, level)) {
      if (front.sectors(centre) == 0) front.empty.erase(centre, front.empty.facet_side(loop[0]).triangle, v[0]);
      return k > offset;
    }
  return true;
}

/// Whether the surface inside the loop stays near the loop: not so for the rim of a dome.
bool is_flat(const Front& front, const std::vector<int>& nodes) {
  const RegionMesh& mesh = front.mesh;
  double share = 1.0 / static_cast<double>(nodes.size()), longest = 0;
  Vec2 p{0, 0};
  Vec3 mean{0, 0, 0};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    p = p + share * mesh.p[nodes[i]];
    mean += share * mesh.x[nodes[i]];
    longest = std::max(longest, norm(mesh.x[nodes[(i + 1) % nodes.size()]] - mesh.x[nodes[i]]));
  }
  return norm(front.region.slope(p).x - mean) < flat_height * longest;
}

}  // namespace

bool close_loop(Front& front, const std::vector<int>& loop) {
  int n = static_cast<int>(loop.size());
  if (!front.is_alone(loop[0], n)) return false;  // the void lies round this loop, not in it
  std::vector<int> v, at;
  for (int i = 0; i < n; ++i) {
    v.push_back(front.facets[loop[i]].a);
    at.push_back(i);
  }
  if (n == 3) return front.form_element(loop[0], v[2], -1, front.facets[loop[0]].level + 1);
  if (front.region.surface->kind() != SurfaceKind::plane && !is_flat(front, v)) return false;
  if (n == 4) return close_quad(front, loop, v);
  if (n % 2 == 1 || n > 8) return false;
  Dissection best = dissect(front.mesh, v, at);
  if (close_star(front, loop, v, std::max(best.worst, n == 6 ? good_enough_six : good_enough))) return true;
  if (best.worst < (n == 6 ? good_enough_six : good_enough)) return false;
  return form_dissection(front, loop, v, best);
}

void insert_triangle(Front& front, const std::vector<int>& loop) {
  int n = static_cast<int>(loop.size());
  if (n == 3) {
    close_loop(front, loop);
    return;
  }
  constexpr double sharp = 85 * M_PI / 180;
  std::vector<std::pair<double, int>> corners;
  for (int f : loop) corners.push_back({front.angle_after(f), f});
  std::sort(corners.begin(), corners.end());
  for (auto [angle, f] : corners) {
    if (angle > sharp) break;
    int level = front.facets[f].level;
    if (front.form_element(f, front.facets[front.facets[f].next].b, -1, level)) return;
  }
  // No sharp corner: a triangle of its own on the first facet that has room, flattest ends first.
  for (std::size_t i = corners.size(); i-- > 0;) {
    int f = corners[i].second;
    const RegionMesh& mesh = front.mesh;
    int a = front.facets[f].a, b = front.facets[f].b;
    const MetricFrame frame = mesh.frame(a);
    constexpr double height_of_unit = 0.866;  // of an equilateral triangle
    const Vec2 side = frame.of(mesh.between(a, b)), up{-side.y, side.x};
    Vec2 p = mesh.p[a] + mesh.pull_back(a, frame.at(0.5 * side + height_of_unit * up));
    Location where = front.empty.walk(front.empty.facet_side(f).triangle, a, p);
    if (where.kind != Location::Kind::inside && where.kind != Location::Kind::on_side) continue;
    int apex = front.add_node(p);
    front.mesh.h[apex] = std::min(mesh.h[apex], norm(side));
    if (!faces_surface(mesh, {{a, b, apex, -1}})) continue;
    if (!front.empty.insert(apex, where)) continue;
    if (front.form_element(f, apex, -1, front.facets[f].level)) return;
    front.empty.erase(apex, front.empty.facet_side(f).triangle, a);
  }
}

void close_by_triangulation(Front& front, int f) {
  ++front.closed_by_triangulation;
  std::vector<Corners> triangles = front.take_void(f);
  // Pairs by quality, best first; ties by position.
  struct Pair {
    double sj;
    std::size_t i, j;
    Corners quad;
  };
  std::vector<Pair> pairs;
  std::vector<std::array<std::size_t, 3>> sides;  // low node, high node, triangle
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      std::size_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    if (sides[s][0] != sides[s + 1][0] || sides[s][1] != sides[s + 1][1]) continue;
    const auto& t = triangles[sides[s][2]];
    const auto& u = triangles[sides[s + 1][2]];
    int a = static_cast<int>(sides[s][0]), b = static_cast<int>(sides[s][1]), k = 0, m = 0;
    while (t[k] == a || t[k] == b) ++k;
    while (u[m] == a || u[m] == b) ++m;
    Corners quad{t[k], t[(k + 1) % 3], u[m], t[(k + 2) % 3]};
    double sj = positive_jacobian(front.mesh, quad);
    if (sj > fair_quad) pairs.push_back({sj, sides[s][2], sides[s + 1][2], quad});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.sj > q.sj; });
  std::vector<bool> is_used(triangles.size(), false);
  for (const Pair& p : pairs) {
    if (is_used[p.i] || is_used[p.j]) continue;
    front.mesh.add_element(p.quad);
    is_used[p.i] = is_used[p.j] = true;
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_used[t]) front.mesh.add_element(triangles[t]);
}

}  // namespace paver
