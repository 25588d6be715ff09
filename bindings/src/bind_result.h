// What the module's parts offer to module.cpp.
#pragma once

#include <pybind11/pybind11.h>

#include "paver/result.h"

namespace paver::python {

/// The classes MeshData and its arrays.
void bind_result(pybind11::module_& module);

/// A MeshData that owns `result`.
pybind11::object wrap_result(MeshResult&& result);

}  // namespace paver::python
