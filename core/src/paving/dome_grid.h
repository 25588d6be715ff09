// Rows and a fan for a region that is a coarse dome: one loop of few nodes about the middle. Rows for a coarse tube.
#pragma once

#include <optional>

#include "mesh/region_mesh.h"
#include "paver/options.h"
#include "regions/region.h"

namespace paver {

/// Where the rows of a dome lie.
enum class DomeRows {
  even,     ///< at equal lengths
  many,     ///< more than twice as many of them
  most,     ///< eight
  in_chart  ///< the same as a few steps in the chart tell: those of long bodies near the loop, where these need it most
};

/// The whole mesh of a region whose one loop goes once about a point, an apex or the chart's pole or its own middle:
/// rows of quads from the loop inwards, as many as the turn asks for, and a fan of half as many quads about that point,
/// a single quad inside four nodes. One triangle where the loop is odd. Nothing where the region is no such dome, its
/// loop has many nodes, or an element is not positive in the chart.
std::optional<RegionMesh> lay_dome(const Region& region, Elements elements, DomeRows rows = DomeRows::even);

/// Whether the ends of a region between two loops are narrower than the target length.
bool is_slim_tube(const Region& region);

/// The same of a region between two loops of equally many nodes, a short bent pipe: rows from one loop to the other.
std::optional<RegionMesh> lay_tube(const Region& region);

/// The same of a prism that goes round, however wide, or of a ring that turns by most of half a circle in a short way.
std::optional<RegionMesh> lay_prism(const Region& region);

}  // namespace paver
