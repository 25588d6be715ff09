// Opposite sides of four-sided and ring-shaped faces given the same interval count.
#pragma once

#include <vector>

#include "boundary/facing/opposite_sides.h"
#include "boundary/parity.h"
#include "topology/model.h"

namespace paver {

/// Edges that take one count together, and the counts of these groups.
struct TiedCounts {
  std::vector<int> group;         ///< per edge: its group
  std::vector<EdgeCount> groups;  ///< wish: the members' mean; minimum: the largest of theirs
  std::vector<char> is_thin;      ///< per pair of opposite sides: of a face far narrower than its intervals
};

/// Ties sides that lie opposite each other on a face with four corners between 45 and 135 degrees and smooth sides, and
/// the two loops of a ring (a tube, an annulus), as long as no member's count comes to differ from its wish by more
/// than rounding or 12 %; where the other two sides of a face cannot be equal, by rounding only. Sides of several edges
/// are tied edge by edge where they have equally many, else by their sums. Faces far narrower than their intervals come
/// first, and may change by half; then large ones. A group with an edge that makes a whole loop gets an even count.
/// `pairs`: of find_opposite_sides with the same `loops`.
TiedCounts tie_opposite_sides(const Model& model, const std::vector<OppositeSides>& pairs,
                              const std::vector<std::vector<Loop>>& loops, const std::vector<EdgeCount>& counts);

}  // namespace paver
