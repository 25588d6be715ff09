// The stage: elements of the paved parts that would be faulty are mended where they are, before parts are joined.
#pragma once

#include <vector>

#include "boundary/edge_nodes.h"
#include "parallel/pave_parts.h"
#include "paver/progress.h"
#include "topology/model.h"

namespace paver {

/// Collective. Every rank mends the parts that it has, each a task; sides on B-rep edges that need a node get it in
/// `nodes` and in all parts, on all ranks. What was done, by face and place, the same on all ranks. What cannot be
/// mended stays: the check of the final mesh names it.
std::vector<ElementRepair> repair_parts(const Model& model, const std::vector<Region>& regions, const Options& options,
                                        EdgeNodes& nodes, PartPaver& paver, const Progress& progress, Ranks& ranks);

}  // namespace paver
