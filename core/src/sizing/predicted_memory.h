// How much memory a run takes.
#pragma once

#include "paver/options.h"

namespace paver {

/// MiB on top of what the process has before, for so many elements.
double predicted_memory_mib(double elements, const Options& options);

}  // namespace paver
