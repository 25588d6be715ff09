// Elements of a face: its area over h^2, and one more for each facet that its boundary has beyond its length over h.
// Short and bent edges make such facets, and rows of small elements before them. How near it comes:
// core/docs/prediction.md.
#include "boundary/prediction.h"

#include <algorithm>

namespace paver {
namespace {

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
    elements[i] += std::max(0.0, facets - size.perimeter[i]);
    if (kind == Elements::all_triangle) elements[i] *= 2;
  }
  return elements;
}

double predict_memory_mib(double elements, const Options& options) {
  int nodes = (options.order + 1) * (options.order + 1);
  return base_mib + elements * (bytes_per_element + bytes_per_node_of_element * nodes) / (1024 * 1024);
}

}  // namespace paver
