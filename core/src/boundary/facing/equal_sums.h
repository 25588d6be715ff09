// Equal counts on opposite sides, kept while loops come out even.
#pragma once

#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "boundary/facing/tie_sides.h"

namespace paver {

/// `tied` has counts that differ by one from those of `before`, for the sake of even loops. Where that leaves sides
/// with unequal sums that had equal ones, as with one more on one side and one less on the other, such a count changes
/// the other way, which keeps loops even: as long as fewer pairs of sides are unequal then, of thin faces
/// before all.
void restore_equal_sums(const std::vector<OppositeSides>& pairs, const TiedCounts& before, TiedCounts& tied);

/// Sets of edges that lie along thin faces whose sides have equal sums, or along such a one and the next: a face would
/// lose that if one of them alone were divided further.
std::vector<std::vector<int>> edges_together(const std::vector<OppositeSides>& pairs, const TiedCounts& tied);

}  // namespace paver
