// A region at a coarser target length.
#pragma once

#include <optional>
#include <vector>

#include "regions/region.h"

namespace paver {

/// Its loops run through some of the nodes of the fine region's loops, all corners among them. A side is what lies
/// between two corners, or a whole loop without any.
struct CoarseRegion {
  Region region;
  std::vector<std::vector<int>> at;    ///< per loop and coarse node: node of the fine loop; the last entry closes it
  std::vector<std::vector<int>> side;  ///< per loop and coarse facet: its side
  std::vector<int> side_intervals;     ///< per side: its fine facets

  int fine_facets(std::size_t loop, std::size_t facet) const { return at[loop][facet + 1] - at[loop][facet]; }
};

/// About every `ratio`-th node stays, evenly spread on each side, an even number on each loop. Nothing where a loop has
/// too few nodes.
std::optional<CoarseRegion> coarsen(const Region& region, int ratio);

}  // namespace paver
