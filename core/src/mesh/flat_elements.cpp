// Flat elements come from closures along a straight edge:
//
//    d-------e          d-------e
//    |       |          |\      |
//    a---b---c    ->    | \     |       the triangle a b c has no height; its side a c would lie on the edge
//    (a c b)            a--b----c
//
// Every outcome is judged as a whole, by its worst element, and must be positive in the chart. It may have no side that
// other elements have already: two quads that share two sides are not both cut from the one end of these to the other.
#include "mesh/flat_elements.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double flat = 0.05;
constexpr double gain = 0.02;     // two triangles for a quad are worth this much: slivers stay quads
constexpr double as_good = 1e-9;  // nearer than this two fillings are as good as each other, the first is taken
constexpr int passes = 3;

using Corners = std::array<int, 4>;

/// A way to fill an outline, with its worst scaled Jacobian.
struct Filling {
  double worst = -1;
  std::vector<Corners> elements;
};

/// -1 where it is not positive.
double value(const RegionMesh& mesh, const Corners& corners) {
  const Element element{corners};
  return is_positive(mesh, element) ? scaled_jacobian(mesh, element) : -1;
}

/// Whether elements other than `gone` have a side between two nodes.
bool is_side(const RegionMesh& mesh, int a, int b, std::initializer_list<int> gone) {
  return std::any_of(mesh.star[a].begin(), mesh.star[a].end(), [&](int e) {
    const Element& element = mesh.elements[e];
    return std::find(gone.begin(), gone.end(), e) == gone.end() && (element.after(a) == b || element.before(a) == b);
  });
}

void try_filling(const RegionMesh& mesh, const std::vector<Corners>& elements, Filling& best) {
  double worst = 1;
  for (const Corners& corners : elements) worst = std::min(worst, value(mesh, corners));
  if (worst > best.worst + as_good) best = {worst, elements};
}

Filling two_triangles(const RegionMesh& mesh, const Corners& v, std::initializer_list<int> gone) {
  Filling best;
  const int least = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin()) % 2;
  for (int i : {least, 1 - least}) {
    int a = v[i], b = v[i + 1], c = v[i + 2], d = v[(i + 3) % 4];
    if (!is_side(mesh, a, c, gone)) try_filling(mesh, {{a, b, c, -1}, {a, c, d, -1}}, best);
  }
  return best;
}

/// An outline of five nodes: a triangle and a quad.
Filling triangle_and_quad(const RegionMesh& mesh, const std::array<int, 5>& v, std::initializer_list<int> gone) {
  Filling best;
  for (int i = 0; i < 5; ++i) {
    if (is_side(mesh, v[i], v[(i + 2) % 5], gone)) continue;
    try_filling(mesh,
                {{v[i], v[(i + 1) % 5], v[(i + 2) % 5], -1}, {v[i], v[(i + 2) % 5], v[(i + 3) % 5], v[(i + 4) % 5]}},
                best);
  }
  return best;
}

/// The element that runs from a to b, or -1.
int element_from(const RegionMesh& mesh, int a, int b) {
  for (int e : mesh.star[a])
    if (mesh.elements[e].after(a) == b) return e;
  return -1;
}

void replace(RegionMesh& mesh, std::initializer_list<int> gone, const Filling& filling) {
  for (int e : gone) mesh.remove_element(e);
  for (const Corners& corners : filling.elements) mesh.add_element(corners);
}

bool mend_quad(RegionMesh& mesh, int e, double least) {
  Filling best = two_triangles(mesh, mesh.elements[e].v, {e});
  if (!(best.worst > std::max(least, 0.0))) return false;
  replace(mesh, {e}, best);
  return true;
}

bool mend_triangle(RegionMesh& mesh, int e, double sj) {
  const Corners v = mesh.elements[e].v;
  int longest = 0;
  auto length = [&](int i) { return norm(mesh.x[v[(i + 1) % 3]] - mesh.x[v[i]]); };
  for (int i : {1, 2})
    if (length(i) > length(longest)) longest = i;
  int a = v[longest], c = v[(longest + 1) % 3], b = v[(longest + 2) % 3];
  int other = element_from(mesh, c, a);
  if (other < 0) return false;
  const Element& neighbour = mesh.elements[other];
  int d = neighbour.after(a), f = neighbour.before(c);
  Filling best = neighbour.corners() == 3 ? two_triangles(mesh, {c, b, a, d}, {e, other})
                                          : triangle_and_quad(mesh, {c, b, a, d, f}, {e, other});
  if (!(best.worst > std::max(std::min(sj, scaled_jacobian(mesh, neighbour)), 0.0))) return false;
  replace(mesh, {e, other}, best);
  return true;
}

}  // namespace

bool split_quad(RegionMesh& mesh, int quad) { return mend_quad(mesh, quad, -1); }

void split_all_quads(RegionMesh& mesh) {
  for (int e = 0, n = static_cast<int>(mesh.elements.size()); e < n; ++e)
    if (mesh.elements[e].corners() == 4) split_quad(mesh, e);
}

long mend_flat_elements(RegionMesh& mesh, bool may_split_quads) {
  long mended = 0;
  for (int pass = 0; pass < passes; ++pass) {
    long before = mended;
    for (int e = 0, n = static_cast<int>(mesh.elements.size()); e < n; ++e) {
      const Element& element = mesh.elements[e];
      if (!element.is_alive()) continue;
      double sj = scaled_jacobian(mesh, element);
      if (sj >= flat || (element.corners() == 4 && !may_split_quads)) continue;
      mended += element.corners() == 4 ? mend_quad(mesh, e, sj + gain) : mend_triangle(mesh, e, sj);
    }
    if (mended == before) break;
  }
  return mended;
}

}  // namespace paver
