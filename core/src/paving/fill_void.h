// The paving loop over one front.
#pragma once

#include "paver/progress.h"
#include "paving/front/front.h"

namespace paver {

/// Lays quads in rows from all loops of a started front until no void is left. Ends on every input: what no row fits
/// in is closed by the void's own triangles, and counted. Throws Error{cancelled} on cancel.
void fill_void(Front& front, const Progress& progress);

}  // namespace paver
