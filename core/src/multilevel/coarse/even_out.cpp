// The mesh as a grid of one chart without gaps in its numbering, smoothed, and put back where that is sound.
#include "multilevel/coarse/even_out.h"

#include "structured/grid_smoothing.h"

namespace paver {
namespace {

// 0.07, as for closed faces, leaves lengths about as even (conesphere_gap: CV 0.057 rather than 0.058) and more skew
// elements (mean scaled Jacobian 0.9947 rather than 0.9956); 0.14 skews fewer (0.9969) but has many more patches.
constexpr double angle_weight = 0.085;

GluedGrid as_grid(const Region& region, const RegionMesh& mesh, const std::vector<std::array<float, 4>>& wishes) {
  GluedGrid grid;
  grid.angle_weight = angle_weight;
  grid.charts = {region.chart};
  grid.chart.assign(mesh.p.size(), 0);
  grid.mesh = mesh;
  grid.mesh.elements.clear();
  for (Star& star : grid.mesh.star) star = {};
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    if (!mesh.elements[e].is_alive()) continue;
    grid.mesh.add_element(mesh.elements[e].v);
    if (!wishes.empty()) grid.wishes.push_back(wishes[e]);
  }
  for (int v = 0; v < mesh.node_count(); ++v)
    if (grid.mesh.star[v].size() == 0) grid.mesh.is_fixed[v] = 1;
  return grid;
}

}  // namespace

void even_out(const Region& region, RegionMesh& mesh, const std::vector<std::array<float, 4>>& wishes, int sweeps,
              const Progress& progress) {
  if (mesh.triangle_count() > 0) return;
  GluedGrid grid = as_grid(region, mesh, wishes);
  smooth_grid(grid, *region.surface, region.size, sweeps, progress);
  std::vector<int> bad;
  for (std::size_t e = 0; e < grid.mesh.elements.size(); ++e)
    if (!is_positive(grid.mesh, grid.mesh.elements[e])) bad.push_back(static_cast<int>(e));
  while (!bad.empty()) {
    const int e = bad.back();
    bad.pop_back();
    for (int v : grid.mesh.elements[e].v) {
      if (grid.mesh.is_fixed[v] || grid.mesh.p[v] == mesh.p[v]) continue;
      grid.mesh.put(v, mesh.place(v));
      grid.mesh.h[v] = mesh.h[v];
      for (int other : grid.mesh.star[v])
        if (!is_positive(grid.mesh, grid.mesh.elements[other])) bad.push_back(other);
    }
  }
  for (int v = 0; v < mesh.node_count(); ++v) {
    if (mesh.is_fixed[v]) continue;
    mesh.put(v, grid.mesh.place(v));
    mesh.h[v] = grid.mesh.h[v];
  }
}

}  // namespace paver
