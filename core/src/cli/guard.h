// The work in a process that may die, and what is said when it does.
#pragma once

#include "arguments.h"
#include "paver/progress.h"

namespace paver {

/// Opens those of stdin, stdout and stderr that are closed, on nothing: else a file to write would be one of them. Call
/// it first.
void open_standard_streams();

/// Goes on in a child of this process, and only there, with a progress that both see and that signals cancel. The
/// process that was called waits and ends as the child does; where a fault of the CAD kernel ended the child, or where
/// it comes to no end with a file, that is said in one sentence and nothing half-written stays. Call it before there
/// are threads. Where no process can be had, work goes on without a guard.
Progress& guard_run(const Arguments& arguments);

/// Prints one line on stderr, whatever the text holds.
void complain(std::string text);

}  // namespace paver
