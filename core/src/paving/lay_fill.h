// A region of a structured layout: its nodes and quads, without paving.
#pragma once

#include <optional>

#include "mesh/region_mesh.h"
#include "regions/region.h"

namespace paver {

/// The whole mesh of a region that has a fill. Nothing where it has none or a quad would not be positive in the chart.
std::optional<RegionMesh> lay_fill(const Region& region);

}  // namespace paver
