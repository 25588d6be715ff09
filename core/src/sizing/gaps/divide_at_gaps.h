// Vertices opposite those at which a narrow gap within a face begins or ends.
#pragma once

#include "paver/options.h"
#include "topology/model.h"

namespace paver {

/// Divides edges of faces where, nearer than a fifth of the target length, one ends that runs along them, as one of two
/// coupled lines beside the other: what lies between has two edges of its own then, of equal length, with nodes that
/// face each other; and both edges where they bend away from each other and come very near, as an eccentric bore and
/// the outer circle. Not edges that have a length of their own.
void divide_at_gaps(Model& model, const Options& options);

}  // namespace paver
