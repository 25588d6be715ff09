// Cracks: free edges of two faces of one part that run along each other, as where sewing left a gap open.
#pragma once

#include <vector>

#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// One place per part where free edges run along each other over a quarter of one of them, nearer than a thousandth of
/// the target length `h` and of that edge, in the order of the model's parts: both names of a Gap are the part's.
std::vector<Gap> find_cracks(const Model& model, double h);

}  // namespace paver
