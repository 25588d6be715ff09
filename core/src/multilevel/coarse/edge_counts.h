// How many fine edges each coarse edge is divided into.
#pragma once

#include <optional>
#include <vector>

#include "multilevel/coarse/coarse_net.h"

namespace paver {

/// One count per chord where that is possible, so that its quads can be mapped; where the sides of the region do not
/// agree a chord changes its count at one quad, by an even number unless the region itself is odd. The counts on each
/// side of the region add up to its fine facets. `wishes`: per edge, its length in fine target lengths.
/// Nothing where no counts fit.
std::optional<std::vector<int>> choose_edge_counts(const CoarseRegion& coarse, const CoarseNet& net,
                                                   const std::vector<Chord>& chords, const std::vector<double>& wishes);

}  // namespace paver
