// Seams and transition seams.
#include "paving/rows/seam.h"

#include <algorithm>

#include "base/predicates.h"
#include "paving/rows/node_placement.h"

namespace paver {
namespace {

constexpr double deg = M_PI / 180;
constexpr double seam_angle = 30 * deg, seam_angle_crowded = 50 * deg;  // crowded: five or more edges
constexpr double transition_ratio = 2.5;                                // of the facets' lengths [Owen99]
constexpr int most_rounds = 8;                                          // of seams that make their neighbours sharp

bool shares_neighbour(const RegionMesh& mesh, int a, int c, int b) {
  for (int e : mesh.star[a])
    for (int g : mesh.star[c])
      for (int p : {mesh.elements[e].after(a), mesh.elements[e].before(a)})
        for (int q : {mesh.elements[g].after(c), mesh.elements[g].before(c)})
          if (p == q && p != b) return true;
  return false;
}

bool share_element(const RegionMesh& mesh, int a, int c) {
  for (int e : mesh.star[a])
    if (mesh.elements[e].corner_of(c) >= 0) return true;
  return false;
}

}  // namespace

bool wants_seam(const Front& front, int f, double angle) {
  int b = front.facets[f].b, edges = front.mesh.star[b].size() + 1;
  if (front.mesh.star[b].size() == 0) return false;  // a corner of the boundary
  return angle < (edges >= 5 ? seam_angle_crowded : seam_angle);
}

bool close_seam(Front& front, int f) {
  RegionMesh& mesh = front.mesh;
  const Facet first = front.facets[f], second = front.facets[first.next];
  int a = first.a, b = first.b, c = second.b;
  if (front.facets[second.next].b == a || a == c) return false;  // a loop of three or four is closed otherwise
  if (front.facets[front.facets[second.next].next].b == a) return false;
  if (mesh.is_fixed[a] && mesh.is_fixed[c]) return false;
  double la = mesh.length(a, b), lc = mesh.length(c, b);
  if (std::max(la, lc) > transition_ratio * std::min(la, lc)) {
    if (front.divide_facet(la > lc ? f : first.next) < 0) return false;
    close_seam(front, front.facets[front.facet_from(b)].prev);
    return true;
  }
  if (shares_neighbour(mesh, a, c, b) || share_element(mesh, a, c)) return false;
  Vec2 pa = mesh.p[a], pc = mesh.p[c];
  if (mesh.is_fixed[a] || mesh.is_fixed[c]) return front.close_seam(f, mesh.is_fixed[a] ? pa : pc);
  return front.close_seam(f, 0.5 * (pa + pc)) || front.close_seam(f, pa) || front.close_seam(f, pc);
}

bool close_seams(Front& front, std::vector<int>& nodes) {
  bool is_changed = false;
  // Work list: closing one seam changes the angles of its neighbours.
  for (int round = 0; round < most_rounds && !nodes.empty(); ++round) {
    std::vector<std::pair<double, int>> sharp;
    for (int node : nodes) {
      int out = front.facet_from(node);
      if (out < 0 || front.sectors(node) != 1) continue;
      int f = front.facets[out].prev;
      double angle = front.angle_after(f);
      if (wants_seam(front, f, angle)) sharp.push_back({angle, node});
    }
    std::sort(sharp.begin(), sharp.end());
    nodes.clear();
    for (auto [angle, node] : sharp) {
      int out = front.facet_from(node);
      if (out < 0 || front.sectors(node) != 1) continue;
      int f = front.facets[out].prev, a = front.facets[f].a, c = front.facets[out].b;
      if (!close_seam(front, f)) continue;
      is_changed = true;
      nodes.push_back(front.sectors(a) > 0 ? a : c);
    }
  }
  nodes.clear();
  return is_changed;
}

}  // namespace paver
