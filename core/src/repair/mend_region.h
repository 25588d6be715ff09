// Bad elements of a region's mesh are mended where they are, a few rings about them.
#pragma once

#include "paver/options.h"
#include "repair/divide_sides.h"
#include "repair/refill.h"

namespace paver {

/// What was done, and what is left.
struct Mended {
  long moved = 0;                   ///< places where nodes inside moved
  long refilled = 0;                ///< places whose elements are others now
  long divided = 0;                 ///< sides inside that got a node
  std::vector<int> left;            ///< elements that are not valid still
  std::vector<SideToDivide> sides;  ///< of these, on B-rep edges, one each: with a node there they may be mended
  bool has_changed() const { return moved + refilled + divided > 0; }
};

/// `bad`: elements of the mesh that are not valid when curved to `order`. Each is mended in the first way that makes
/// all elements about it valid, or failing that by the one that gains most: free corners move; a few elements about it
/// are filled anew; a side inside gets a node. Fixed nodes stay, and what is farther away is not touched. Takes at most
/// a bounded number of steps per bad element.
Mended mend_region(const Region& region, const EdgeNodes& edges, int order, Elements elements, std::vector<int> bad,
                   RegionMesh& mesh);

}  // namespace paver
