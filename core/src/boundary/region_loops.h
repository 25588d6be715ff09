// A face's loops as paving sees them: without periodic edges and poles where the face wraps.
#pragma once

#include <vector>

#include "topology/model.h"

namespace paver {

/// Per loop and coedge of `face`: true where the coedge is one side of a periodic edge, that is where the face uses the
/// edge twice and the two uses lie apart in (u, v) on a surface that is closed there.
/// (A slit, used twice at the same (u, v), is boundary and stays.)
std::vector<std::vector<bool>> periodic_coedges(const Model& model, int face);

/// The same without edges that other faces or wires have as well: these must keep their nodes.
std::vector<std::vector<bool>> own_periodic_coedges(const Model& model, int face);

/// The loops of `face` (0-based) without its own periodic edges and degenerate ones: what remains is chained anew by
/// vertices (circle, periodic edge, circle, periodic edge gives two circles; a hole cut by the periodic edge becomes
/// one loop). Loops without coedges vanish. Coedges keep their direction, their loop starts with its first coedge in
/// face order.
std::vector<Loop> linked_loops(const Model& model, int face);

/// The same, leaving out degenerate edges and the coedges marked in `dropped` (per loop and coedge).
std::vector<Loop> linked_loops(const Model& model, int face, const std::vector<std::vector<bool>>& dropped);

}  // namespace paver
