// Two quads that share two sides are not both cut from the one end of these to the other: that would be one mesh edge.
#include "mesh/split_quads.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double as_good = 1e-9;  // nearer than this two diagonals are as good as each other, the first is taken

void split_quad(RegionMesh& mesh, int quad) {
  const Corners v = mesh.elements[quad].v;
  const int least = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin()) % 2;
  double worst = 0;
  std::array<Corners, 2> best{};
  for (int i : {least, 1 - least}) {
    const int a = v[i], b = v[i + 1], c = v[i + 2], d = v[(i + 3) % 4];
    const std::array<Corners, 2> halves{{{a, b, c, -1}, {a, c, d, -1}}};
    const double both =
        mesh.has_side(a, c) ? -1 : std::min(positive_jacobian(mesh, halves[0]), positive_jacobian(mesh, halves[1]));
    if (both > worst + as_good) worst = both, best = halves;
  }
  if (worst <= 0) return;
  mesh.remove_element(quad);
  for (const Corners& corners : best) mesh.add_element(corners);
}

}  // namespace

void split_all_quads(RegionMesh& mesh) {
  for (int e = 0, n = static_cast<int>(mesh.elements.size()); e < n; ++e)
    if (mesh.elements[e].is_alive() && mesh.elements[e].corners() == 4) split_quad(mesh, e);
}

}  // namespace paver
