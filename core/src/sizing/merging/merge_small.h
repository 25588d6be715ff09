// What is small against the target length is not resolved: chains of short edges are divided as one, thin and tiny
// faces are left to their neighbours.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// Changes the model; gives what was merged. Nothing where options.merge is 0.
std::vector<Merge> merge_small(Model& model, const Options& options);

/// One sentence, or nothing.
std::string note_merges(const std::vector<Merge>& merges);

}  // namespace paver
