// The whole mesh of a region with few nodes about it.
#pragma once

#include <optional>

#include "repair/edits/refill.h"

namespace paver {

/// Of quads only: a row along a smooth part of the loop and the best filling of what it leaves; of all such parts that
/// with the best worst element. Nothing where the region has more than one loop, a fan, more nodes than are filled
/// anew, or no such part.
std::optional<RegionMesh> fill_with_row(const Region& region, const BoundarySides& sides, int order);

}  // namespace paver
