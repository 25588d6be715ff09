// Faces that are narrow against the target length.
#pragma once

#include <vector>

#include "paver/result.h"
#include "sizing/merging/merge_limits.h"

namespace paver {

/// A face narrower than the limit whose neighbours on one side go on without a corner is left out: these end at its
/// other side. Adds what was merged.
void merge_thin_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

}  // namespace paver
