// Work of the core on a thread of its own while Python waits.
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <string>

#include "paver/progress.h"

namespace paver::python {

/// Text of the core as Python's; names from CAD files and of files may not be UTF-8.
pybind11::str to_python(const std::string& text);

/// Runs `work` without the interpreter lock and waits for it. Before it starts and then twenty times a second the
/// calling thread takes the lock, looks for signals and calls `poll(stage name, fraction)` (None: nobody is asked).
/// An answer of False cancels the work: Error{cancelled}. An exception in `poll`, or KeyboardInterrupt, cancels it too
/// and is thrown on once the work has ended. What `work` throws is thrown as Error. After a good end `poll` is told
/// ("done", 1).
void run_job(const pybind11::object& poll, const std::function<void(Progress&)>& work);

/// Cancels all work and waits until it has ended: no thread may be inside when the interpreter goes.
void cancel_all_jobs();

}  // namespace paver::python
