// Steps of merge_small; each adds what it has merged.
#pragma once

#include <vector>

#include "paver/result.h"
#include "sizing/merging/merge_limits.h"

namespace paver {

/// Edges that run on without a corner, where one of them is short against the target length, become one, on the curves
/// that they have.
void join_chains(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

/// Faces that go round and end in a tiny rim end in a pole.
void close_tiny_rims(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

/// Faces that are as small in all directions become points. Gives thin ones that ended there and are to be merged for
/// it.
std::vector<int> collapse_tiny_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

/// A face narrower than the limit whose neighbours on one side go on without a corner is left out: these end at its
/// other side. Gives faces on whose leaving others counted, and which could not be left out.
std::vector<int> merge_thin_faces(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

/// Short edges that others go on from without a corner become points.
void collapse_short_edges(ModelEdits& edits, const MergeLimits& limits, std::vector<Merge>& merges);

}  // namespace paver
