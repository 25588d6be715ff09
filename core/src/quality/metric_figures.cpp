#include "quality/metric_figures.h"

#include <algorithm>
#include <cmath>

#include "base/tasks/tasks.h"
#include "quality/reduction.h"

namespace paver {
namespace {

constexpr double band_low = 0.5, band_high = 1.5;  // length by target length

struct Totals {
  long elements = 0, sides = 0, in_band = 0;
  double least_sj = INFINITY;
  ExactSum sj, length;

  void add(const RegionMesh& mesh, const Element& e) {
    const double jacobian = scaled_jacobian(mesh, e);
    ++elements;
    least_sj = std::min(least_sj, jacobian);
    sj.add(jacobian);
    for (int k = 0, n = e.corners(); k < n; ++k) {
      const double ratio = mesh.relative_length(e.v[k], e.v[(k + 1) % n]);
      ++sides;
      in_band += ratio >= band_low && ratio <= band_high;
      length.add(ratio);
    }
  }

  void add(const Totals& other) {
    elements += other.elements, sides += other.sides, in_band += other.in_band;
    least_sj = std::min(least_sj, other.least_sj);
    sj.add(other.sj), length.add(other.length);
  }
};

}  // namespace

MetricFigures measure_metric(const std::vector<const RegionMesh*>& meshes, int threads, const Progress& progress,
                             Ranks& ranks) {
  std::vector<Totals> of_part(meshes.size());
  std::vector<double> costs;
  for (const RegionMesh* mesh : meshes) costs.push_back(mesh ? static_cast<double>(mesh->elements.size()) : 0);
  run_tasks(threads, costs, [&](int i) {
    progress.check();
    const auto part = static_cast<std::size_t>(i);
    if (!meshes[part]) return;
    for (const Element& e : meshes[part]->elements)
      if (e.is_alive()) of_part[part].add(*meshes[part], e);
  });
  Totals all;
  for (const Totals& totals : of_part) all.add(totals);
  Reduction reduction;
  for (long* number : {&all.elements, &all.sides, &all.in_band}) reduction.sum(*number);
  for (ExactSum* sum : {&all.sj, &all.length}) reduction.sum(*sum);
  reduction.least(all.least_sj);
  reduction.run(ranks);
  MetricFigures figures;
  if (all.elements == 0) return figures;
  figures.least_sj = all.least_sj;
  figures.mean_sj = all.sj.total() / static_cast<double>(all.elements);
  figures.length_mean = all.length.total() / static_cast<double>(all.sides);
  figures.length_in_band = static_cast<double>(all.in_band) / static_cast<double>(all.sides);
  return figures;
}

}  // namespace paver
