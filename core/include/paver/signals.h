// How a user or a system stops a program that meshes.
#pragma once

#include "paver/progress.h"

namespace paver {

/// Makes SIGINT, SIGTERM and SIGHUP cancel `progress`, which must live as long as the process. A file that grows
/// beyond a limit and a reader that goes away become write errors instead of signals.
void cancel_on_signals(Progress& progress);

}  // namespace paver
