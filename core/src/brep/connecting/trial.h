// Reading in a process that may die, before this one reads: for files that are not as a writer leaves them.
#pragma once

#include "brep/reading/read_shape.h"
#include "paver/progress.h"

namespace paver {

/// Lets another process read a doubtful file and build its topology. Throws what that process refuses the file with,
/// Error{damaged_file} when the CAD kernel breaks down there or comes to no end, Error{out_of_memory}, Error{internal}
/// without the program for it. What else is wrong with the file is for this process to find. Nothing where this process
/// may break down (may_break_down()).
void try_elsewhere(const FileSource& file, const Progress& progress);

}  // namespace paver
