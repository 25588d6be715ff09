// Trying a file for another process.
#pragma once

namespace paver {

/// Reads the file at `path`, which is called `name`, and builds its topology for the process `asking`, and ends with
/// it. The exit code, where the CAD kernel does not break down (paver/breakdown.h).
int try_file(const char* path, const char* name, long asking);

}  // namespace paver
