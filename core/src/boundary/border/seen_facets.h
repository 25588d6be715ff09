// Long facets close before nodes of their own face.
#pragma once

#include <vector>

#include "boundary/border/border_facets.h"
#include "topology/model.h"

namespace paver {

/// More intervals for edges of few, where a node of the same face sees one of them at a blunt angle and the node's own
/// facets are shorter: elements from there to the ends of the facet would be needles. Not where that takes more than a
/// few. `loops[f]`: linked_loops of face f without periodic edges; edges with nodes `opposite` vertices stay.
void divide_seen_facets(const Model& model, const std::vector<std::vector<Loop>>& loops, const OppositeShares& opposite,
                        std::vector<EdgeCount>& counts);

}  // namespace paver
