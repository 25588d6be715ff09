#include "check/checked_mesh.h"

namespace paver {

std::vector<PartPlace> places_of(const CheckedMesh& checked) {
  std::vector<PartPlace> places;
  PartPlace next{checked.shared_nodes};
  for (const PartSizes& sizes : checked.sizes) {
    places.push_back(next);
    next.node += static_cast<int>(sizes.nodes);
    next.quad += static_cast<std::size_t>(sizes.quads);
    next.triangle += static_cast<std::size_t>(sizes.triangles);
  }
  return places;
}

std::vector<double> costs_of(const CheckedMesh& checked) {
  std::vector<double> costs;
  for (const PartSizes& sizes : checked.sizes) costs.push_back(static_cast<double>(sizes.quads + sizes.triangles));
  return costs;
}

}  // namespace paver
