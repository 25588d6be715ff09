// Clean-up of a paved region: fewer irregular nodes, no doublets, then
// smoothing.
#pragma once

#include "paver/progress.h"
#include "paving/front/front.h"

namespace paver {

/// With `all_quad` pairs of triangles become quads wherever those are positive, however poor. `first_node`: those
/// before it are cleaned up already; their elements change only from where newer nodes are.
void clean_up(Front& front, const Progress& progress, bool all_quad = false, int first_node = 0);

}  // namespace paver
