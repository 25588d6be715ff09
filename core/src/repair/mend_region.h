// Bad elements of a region's mesh are mended where they are, a few rings about them.
#pragma once

#include "paver/result.h"
#include "repair/divide_sides.h"
#include "repair/edits/refill.h"

namespace paver {

/// One place that was mended.
struct MendedPlace {
  ElementRepairKind kind = ElementRepairKind::moved;
  Vec3 where;
};

/// What was done, and what is left.
struct Mended {
  std::vector<MendedPlace> places;  ///< in the order in which they were mended
  std::vector<int> left;            ///< elements that are not valid still
  std::vector<SideToDivide> sides;  ///< of these, on B-rep edges, one each: with a node there they may be mended
};

/// `bad`: elements of the judge's mesh, `mesh`, that are not valid when curved, or poor. Each is mended in the first
/// way that makes all elements about it fair, or failing that by the one that gains most: free corners move; a few
/// elements about it are filled anew; of those that are not valid a side inside gets a node. Fixed nodes stay, and what
/// is farther away is not touched. Takes at most a bounded number of steps per bad element.
Mended mend_region(const ElementJudge& judge, ElementKinds kinds, std::vector<int> bad, RegionMesh& mesh);

}  // namespace paver
