// Edges that are short against the target length, and faces that are small in all directions.
#pragma once

#include <vector>

#include "paver/result.h"
#include "sizing/merging/merge_limits.h"

namespace paver {

/// Short edges that others go on from without a corner become points. Adds what was merged.
void collapse_short_edges(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

/// The same of faces that are as small in all directions. Gives thin faces that ended at one and are to be merged for it.
std::vector<int> collapse_tiny_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

}  // namespace paver
