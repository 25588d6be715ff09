// What the target length grows from.
#pragma once

#include <vector>

#include "base/boxes/nearest_segment.h"

namespace paver {

/// Its value is the target length on it, mm.
using SizeSource = Segment;

/// Moves what lies about a round hole out to where the rings of quads about it end (paving/closing/hole_rings): they
/// grow as their columns get wider, faster than by the gradation. Nothing happens where it is not round, is divided
/// too coarsely for rings, or has room for one only.
/// `hole`: group `index` of the face's `borders`, which have no values and grow by 1.
void start_where_rings_end(std::vector<SizeSource>& hole, std::size_t index, const NearestSegment& borders);

}  // namespace paver
