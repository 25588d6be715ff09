// Clean-up of a paved region: fewer irregular nodes, no doublets, then
// smoothing.
#pragma once

#include "paver/progress.h"
#include "paving/front.h"

namespace paver {

void clean_up(Front& front, const Progress& progress);

}  // namespace paver
