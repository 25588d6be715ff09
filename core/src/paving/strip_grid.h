// A regular grid for a region that is a narrow strip.
#pragma once

#include <optional>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// The whole mesh of a region with one loop of four sides, equally many nodes on opposite ones, that is narrower than
/// the target length: nodes of the long sides face each other. Nothing where the region is no such strip, or the grid
/// is poor.
std::optional<RegionMesh> lay_strip(const Region& region);

/// The same of any width with so many elements at most, however poor; no turns count, as elements as long as waves of
/// the surface have no place among lengths that count them.
std::optional<RegionMesh> lay_four_sided(const Region& region, std::size_t most_elements);

}  // namespace paver
