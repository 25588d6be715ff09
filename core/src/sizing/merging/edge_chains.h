// Chains of edges that are divided as one.
#pragma once

#include <vector>

#include "paver/result.h"
#include "sizing/merging/merge_limits.h"

namespace paver {

/// Edges that run on without a corner, where one of them is short against the target length, become one, on the curves
/// that they have. Adds what was merged.
void join_chains(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

}  // namespace paver
