// What the module's parts offer to module.cpp.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <tuple>

#include "paver/output.h"
#include "paver/result.h"

namespace paver::python {

/// The classes MeshData and its arrays.
void bind_result(pybind11::module_& module);

/// What Python passes: paths of mesh and report, "4.1" or "2.2", whether as text, path of the model; path and text of
/// the repaired model.
using FileArguments = std::tuple<std::string, std::string, std::string, bool, std::string, std::string, std::string>;

/// Throws bad_option for another version.
OutputFiles output_files(const FileArguments& arguments);

/// A MeshData that owns `result`.
pybind11::object wrap_result(MeshResult&& result);

}  // namespace paver::python
