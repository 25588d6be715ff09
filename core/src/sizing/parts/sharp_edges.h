// Edges at which currents are singular.
#pragma once

#include <vector>

#include "topology/model.h"

namespace paver {

/// Per edge of the model: whether the surface ends there, or has a corner of more than 40 degrees that is outside of
/// its solid; of sheets either way.
std::vector<bool> find_sharp_edges(const Model& model);

}  // namespace paver
