// Trying a file for another process.
#pragma once

namespace paver {

/// Reads the file at `path` and builds its topology for the process `asking`, and ends with it. The exit code, where
/// the CAD kernel does not break down (paver/breakdown.h).
int try_file(const char* path, long asking);

}  // namespace paver
