// Meshes from arrays, and what is drawn and picked of a mesh.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>

#include "paver/quality.h"
#include "paver/result.h"

namespace paver::python {

/// What is measured and drawn of any mesh.
class Measured {
 public:
  virtual ~Measured() = default;
  virtual const SurfaceMesh& mesh() const = 0;

  /// The fields of Python's ElementQuality, measured at the first call.
  pybind11::dict quality();
  /// The fields of Python's Tessellation.
  pybind11::dict tessellate(int subdivision, bool apart) const;

 private:
  std::shared_ptr<const ElementQuality> quality_;
  std::mutex mutex_;
};

/// The classes Measured, BareMesh and Picker.
void bind_display(pybind11::module_& module);

}  // namespace paver::python
