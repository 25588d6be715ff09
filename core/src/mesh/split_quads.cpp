// Two quads that share two sides are not both cut from the one end of these to the other: that would be one mesh edge.
#include "mesh/split_quads.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double as_good = 1e-9;  // nearer than this two diagonals are as good as each other, the first is taken

/// Halves that look away from the surface come after all others: a quad bent round a nose may have no better ones.
constexpr double turned_away = 1;

double worth(const RegionMesh& mesh, const Corners& corners) {
  const Element half{corners};
  if (!turns_left(mesh, half)) return -2 * turned_away;
  return scaled_jacobian(mesh, half) - (faces_surface(mesh, half) ? 0 : turned_away);
}

void split_quad(RegionMesh& mesh, int quad) {
  const Corners v = mesh.elements[quad].v;
  const int least = static_cast<int>(std::min_element(v.begin(), v.end()) - v.begin()) % 2;
  double worst = -turned_away;
  std::array<Corners, 2> best{};
  for (int i : {least, 1 - least}) {
    const int a = v[i], b = v[i + 1], c = v[i + 2], d = v[(i + 3) % 4];
    const std::array<Corners, 2> halves{{{a, b, c, -1}, {a, c, d, -1}}};
    const double both =
        mesh.has_side(a, c) ? -2 * turned_away : std::min(worth(mesh, halves[0]), worth(mesh, halves[1]));
    if (both > worst + as_good) worst = both, best = halves;
  }
  if (worst <= -turned_away) return;
  mesh.remove_element(quad);
  for (const Corners& corners : best) mesh.add_element(corners);
}

}  // namespace

void split_all_quads(RegionMesh& mesh) {
  for (int e = 0, n = static_cast<int>(mesh.elements.size()); e < n; ++e)
    if (mesh.elements[e].is_alive() && mesh.elements[e].corners() == 4) split_quad(mesh, e);
}

}  // namespace paver
