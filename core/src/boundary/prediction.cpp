// Elements of a face: its area over h^2, and more for facets that its boundary has beyond its length over h: short and
// bent edges make such facets, and rows of small elements before them, twice as many about holes, whose rows widen. A
// strip narrower than h has one row of elements between its facets. How near it comes: core/docs/prediction.md.
#include "boundary/prediction.h"

#include <algorithm>

namespace paver {
namespace {

constexpr double rows_about_holes = 1.9;  // of the facets that holes have more: docs/prediction.md
constexpr double base_mib = 10;
constexpr double bytes_per_element = 350, bytes_per_node_of_element = 50;

}  // namespace

std::vector<double> predict_elements(const Model& model, const SizeField& size, const std::vector<int>& counts,
                                     Elements kind) {
  std::vector<double> elements = size.predicted;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    if (elements[i] <= 0) continue;
    double facets = 0;
    for (const Coedge& coedge : coedges_of(model.faces[i].loops)) facets += counts[coedge.edge];
    const bool has_holes = model.faces[i].loops.size() > 1;
    const bool is_strip = !has_holes && elements[i] <= std::max(1.0, 0.5 * size.perimeter[i] - 1);
    const double more = (has_holes ? rows_about_holes : 1) * std::max(0.0, facets - size.perimeter[i]);
    elements[i] = is_strip ? std::max(1.0, 0.5 * facets - 1) : elements[i] + more;
    if (kind == Elements::all_triangle) elements[i] *= 2;
  }
  return elements;
}

double predict_memory_mib(double elements, const Options& options) {
  int nodes = (options.order + 1) * (options.order + 1);
  return base_mib + elements * (bytes_per_element + bytes_per_node_of_element * nodes) / (1024 * 1024);
}

}  // namespace paver
