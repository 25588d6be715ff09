// A regular grid for a region that is a disc: one smooth loop.
#pragma once

#include <optional>

#include "mesh/region_mesh.h"
#include "paver/progress.h"
#include "regions/region.h"

namespace paver {

/// The whole mesh of a region with one loop and no corners: a core of a x b quads, and rows around it to the loop; four
/// nodes of valence 3, no other irregular one. Nothing where the region is no such disc, its loop is odd, or paving
/// promises more even elements.
std::optional<RegionMesh> lay_disc(const Region& region, const Progress& progress);

}  // namespace paver
