// Small holes, cut into the mesh of a region that was paved as if they were not there.
#pragma once

#include <vector>

#include "paving/front/front.h"

namespace paver {

/// Loops that are holes of a few facets, an even number, far enough from all other loops.
std::vector<std::size_t> small_holes(const Region& region);

Region without_holes(const Region& region, const std::vector<std::size_t>& holes);

/// Takes the elements about the holes out of the front's mesh, which is that of its region without them, adds their
/// boundary nodes and starts the front with the void between: about `width` target lengths, at either side of a hole.
/// False where that void is not sound.
bool cut_holes(Front& front, const std::vector<std::size_t>& holes, double width);

}  // namespace paver
