#include "repair/find_bad.h"

#include <algorithm>

#include "curving/near_surface.h"
#include "repair/edits/row_along.h"

namespace paver {
namespace {

// Where all hold, a curved side leaves its chord by less than a tenth of it, and no two sides of a corner meet.
constexpr double least_along = 0.94;    // cosine, from the element's normal to the surface's at its corners
constexpr double least_jacobian = 0.4;  // scaled
// Between the derivatives at the ends of a side, of its chord; where it turns more the surface may do anything between.
constexpr double most_side_turn = 0.4;
constexpr double most_bulge = 0.1;   // of its chord, of a side on a B-rep edge
constexpr double least_share = 0.2;  // of a side, by the opposite one

bool is_flat(const RegionMesh& mesh, const Element& e, int n) {
  Vec3 area;
  for (int k = 1; k + 1 < n; ++k) area += cross(mesh.x[e.v[k]] - mesh.x[e.v[0]], mesh.x[e.v[k + 1]] - mesh.x[e.v[0]]);
  area = unit(area);
  return std::all_of(e.v.begin(), e.v.begin() + n, [&](int v) { return dot(area, mesh.normal(v)) > least_along; });
}

bool has_even_sides(const RegionMesh& mesh, const Element& e, int n) {
  for (int k = 0; k < n; ++k)
    if (!SideCubic(mesh, e.v[k], e.v[k + 1 < n ? k + 1 : 0]).is_smooth(most_side_turn)) return false;
  return true;
}

bool has_flat_sides(const ElementJudge& judge, const Element& e, int n) {
  const RegionMesh& mesh = judge.mesh();
  for (int k = 0; k < n; ++k) {
    const int a = e.v[k], b = e.v[(k + 1) % n];
    if (mesh.global[a] < 0 || mesh.global[b] < 0) continue;
    if (mesh.global[a] == mesh.global[b]) return false;
    const BoundarySide* side = judge.sides().find(mesh.global[a], mesh.global[b]);
    const Vec3 chord = mesh.x[b] - mesh.x[a];
    if (side && norm(side->middle - mesh.x[a] - 0.5 * chord) > most_bulge * norm(chord)) return false;
    if (side && is_straight(judge, e.v[(k + n - 1) % n], a, b, least_jacobian)) return false;
  }
  return true;
}

/// Between opposite ones: the Jacobian of a quad goes from one to the other.
bool has_like_sides(const RegionMesh& mesh, const Element& e, int n) {
  if (n == 3) return true;
  for (int k : {0, 1}) {
    const Vec3 one = mesh.x[e.v[k + 1]] - mesh.x[e.v[k]], other = mesh.x[e.v[(k + 3) % 4]] - mesh.x[e.v[k + 2]];
    const auto [less, more] = std::minmax({dot(one, one), dot(other, other)});
    if (less < least_share * least_share * more) return false;
  }
  return true;
}

bool is_bad(const ElementJudge& judge, const Element& e) {
  if (!has_jacobian(judge.mesh(), e, fair)) return true;
  const double value = judge.value(e.v);
  return value <= 0 || (value < fair && judge.order() > 1);
}

}  // namespace

std::vector<int> find_bad(const ElementJudge& judge) {
  const RegionMesh& mesh = judge.mesh();
  std::vector<int> bad;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const Element& e = mesh.elements[i];
    if (!e.is_alive()) continue;
    const int n = e.corners();
    const bool is_plain = has_jacobian(mesh, e, least_jacobian) && is_flat(mesh, e, n) && is_positive(mesh, e) &&
                          has_like_sides(mesh, e, n) && has_flat_sides(judge, e, n) && has_even_sides(mesh, e, n);
    if (!is_plain && is_bad(judge, e)) bad.push_back(static_cast<int>(i));
  }
  return bad;
}

}  // namespace paver
