// Equal counts along bent strips that are narrower than their intervals bulge.
#pragma once

#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Of a face between four corners whose long sides bulge from the chords of their intervals by more than half of its
/// width the side of fewer intervals gets as many as the other: chords of unequal ones would cross.
void match_bent_strips(const Model& model, const std::vector<OppositeSides>& pairs, std::vector<EdgeCount>& counts);

}  // namespace paver
