// Meshes from arrays, and what is drawn and picked of a mesh.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "paver/quality.h"
#include "paver/result.h"

namespace paver::python {

/// The classes SurfaceMesh and PickTree.
void bind_display(pybind11::module_& module);

/// The fields of Python's Tessellation.
pybind11::dict tessellation_arrays(const SurfaceMesh& mesh, int subdivision, bool apart);

/// The fields of Python's ElementQuality.
pybind11::dict quality_arrays(const std::shared_ptr<const ElementQuality>& figures);

}  // namespace paver::python
