// Exceptions of the CAD kernel, for stages that do not know it.
#pragma once

#include <functional>

#include "paver/error.h"

namespace paver {

/// Runs `task`; what the kernel throws becomes Error{face_failed} at `where`.
void guard_kernel(const Where& where, const std::function<void()>& task);

}  // namespace paver
