#include "support/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/predicates.h"
#include "support/planar_region.h"

namespace paver::test {
namespace {

/// Twice the area, without cancellation against a far origin.
long double double_area(const std::vector<Vec2>& points, const int* v, int n) {
  long double sum = 0;
  for (int i = 1; i + 1 < n; ++i) {
    Vec2 a = points[v[i]] - points[v[0]], b = points[v[i + 1]] - points[v[0]];
    sum += static_cast<long double>(a.x) * b.y - static_cast<long double>(a.y) * b.x;
  }
  return sum;
}

std::string area_fault(long double sum, double area) {
  double relative = static_cast<double>(std::fabs(sum / area - 1));
  return relative <= 1e-12 ? "" : fmt::format("areas add up to {} of {}\n", static_cast<double>(sum), area);
}

std::string neighbour_faults(const VoidTriangulation& empty, int t) {
  const VoidTriangle& tri = empty.triangle(t);
  std::string faults;
  for (int i = 0; i < 3; ++i) {
    int n = tri.n[i], a = tri.v[(i + 1) % 3], b = tri.v[(i + 2) % 3];
    if (n == -1) faults += fmt::format("triangle {} has nothing across {}-{}\n", t, a, b);
    if (n < 0) continue;
    const VoidTriangle& other = empty.triangle(n);
    int j = other.is_alive ? empty.side_between(n, a, b) : -1;
    if (j < 0 || other.n[j] != t || other.v[(j + 1) % 3] != b)
      faults += fmt::format("triangles {} and {} disagree on {}-{}\n", t, n, a, b);
  }
  return faults;
}

std::string facet_faults(const VoidTriangulation& empty, const std::vector<std::pair<int, int>>& facets) {
  std::string faults;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (facets[f].first < 0) continue;
    Side side = empty.facet_side(static_cast<int>(f));
    if (side.triangle < 0 || !empty.triangle(side.triangle).is_alive) {
      faults += fmt::format("facet {} has no triangle\n", f);
      continue;
    }
    const VoidTriangle& tri = empty.triangle(side.triangle);
    bool is_on_side = tri.n[side.corner] == facet_code(static_cast<int>(f)) &&
                      tri.v[(side.corner + 1) % 3] == facets[f].first &&
                      tri.v[(side.corner + 2) % 3] == facets[f].second;
    if (!is_on_side) faults += fmt::format("facet {} is not on its triangle's side\n", f);
  }
  return faults;
}

}  // namespace

std::string void_faults(const VoidTriangulation& empty, const std::vector<Vec2>& points,
                        const std::vector<std::pair<int, int>>& facets, double area) {
  std::string faults = facet_faults(empty, facets);
  std::size_t outer = 0, live = 0;
  long double sum = 0;
  for (int t = 0; t < empty.triangle_count(); ++t) {
    const VoidTriangle& tri = empty.triangle(t);
    if (!tri.is_alive) continue;
    if (*std::min_element(tri.v.begin(), tri.v.end()) < 0) return fmt::format("triangle {} is of the frame\n", t);
    if (!(orientation(points[tri.v[0]], points[tri.v[1]], points[tri.v[2]]) > 0))
      faults += fmt::format("triangle {} is not counter-clockwise\n", t);
    faults += neighbour_faults(empty, t);
    outer += std::count_if(tri.n.begin(), tri.n.end(), is_facet);
    sum += double_area(points, tri.v.data(), 3) / 2;
  }
  for (auto [a, b] : facets) live += a >= 0;
  if (outer != live) faults += fmt::format("{} outer sides, {} facets\n", outer, live);
  return faults + (live > 0 || sum > 0 ? area_fault(sum, area) : "");
}

std::string delaunay_faults(const VoidTriangulation& empty, const std::vector<Vec2>& points) {
  std::string faults;
  for (int t = 0; t < empty.triangle_count(); ++t) {
    const VoidTriangle& tri = empty.triangle(t);
    for (int i = 0; tri.is_alive && i < 3; ++i) {
      if (tri.n[i] < t) continue;
      const VoidTriangle& other = empty.triangle(tri.n[i]);
      int far = other.v[empty.side_between(tri.n[i], tri.v[(i + 1) % 3], tri.v[(i + 2) % 3])];
      if (in_circle(points[tri.v[0]], points[tri.v[1]], points[tri.v[2]], points[far]))
        faults += fmt::format("the side between triangles {} and {} is not Delaunay\n", t, tri.n[i]);
    }
  }
  return faults;
}

std::string front_faults(const Front& front) {
  std::vector<std::pair<int, int>> facets;
  std::string faults;
  long double paved = 0;
  for (const Element& e : front.mesh.elements)
    if (e.is_alive()) paved += double_area(front.mesh.p, e.v.data(), e.corners()) / 2;
  for (std::size_t i = 0; i < front.facets.size(); ++i) {
    const Facet& f = front.facets[i];
    facets.push_back(f.is_alive ? std::pair{f.a, f.b} : std::pair{-1, -1});
    if (!f.is_alive) continue;
    const Facet &next = front.facets[f.next], &prev = front.facets[f.prev];
    bool is_linked = next.is_alive && prev.is_alive && next.a == f.b && prev.b == f.a &&
                     next.prev == static_cast<int>(i) && prev.next == static_cast<int>(i);
    if (!is_linked) faults += fmt::format("facet {} is not linked with its neighbours\n", i);
    if (front.sectors(f.a) < 1 || front.facet_from(f.a) < 0) faults += fmt::format("node {} has no sector\n", f.a);
  }
  double area = chart_area(front.region);
  return faults + void_faults(front.empty, front.mesh.p, facets, static_cast<double>(area - paved));
}

std::string paved_faults(const Region& region, const RegionMesh& mesh) {
  std::string faults;
  long double sum = 0;
  std::map<std::pair<int, int>, int> directed;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const Element& e = mesh.elements[i];
    if (!e.is_alive()) continue;
    int n = e.corners();
    for (int k = 0; k < n; ++k) {
      int a = e.v[(k + n - 1) % n], b = e.v[k], c = e.v[(k + 1) % n];
      if (!(orientation(mesh.p[a], mesh.p[b], mesh.p[c]) > 0))
        faults += fmt::format("element {} of {} does not turn left at ({}, {})\n", i, n, mesh.p[b].x, mesh.p[b].y);
      if (++directed[{b, c}] > 1) faults += fmt::format("two elements run along {} -> {}\n", b, c);
    }
    if (std::set<int>(e.v.begin(), e.v.begin() + n).size() != static_cast<std::size_t>(n))
      faults += fmt::format("element {} has a corner twice\n", i);
    sum += double_area(mesh.p, e.v.data(), n) / 2;
  }
  // What lies in one element only must be the facets of the loops, each once.
  std::map<std::pair<int, int>, int> border;
  for (const auto& [edge, count] : directed)
    if (!directed.contains({edge.second, edge.first})) ++border[{mesh.global[edge.first], mesh.global[edge.second]}];
  for (const auto& loop : region.loops)
    for (std::size_t i = 0, n = loop.size(); i < n; ++i) --border[{loop[i].global, loop[(i + 1) % n].global}];
  for (const auto& [edge, count] : border)
    if (count != 0) faults += fmt::format("{} edges {} -> {} too many on the border\n", count, edge.first, edge.second);
  std::map<int, Vec2> places;
  for (const auto& loop : region.loops)
    for (const LoopNode& node : loop) places[node.global] = node.p;
  for (int i = 0; i < mesh.node_count(); ++i)
    if (mesh.star[i].size() > 0 && mesh.global[i] >= 0 && !(places[mesh.global[i]] == mesh.p[i]))
      faults += fmt::format("boundary node {} has moved\n", mesh.global[i]);
  return faults + area_fault(sum, chart_area(region));
}

}  // namespace paver::test
