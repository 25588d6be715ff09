// One reader per format; each gives a shape in millimetres, or throws Error{damaged_file}.
#pragma once

#include "brep/occt_impl.h"
#include "brep/reading/read_shape.h"
#include "brep/shape_impl.h"
#include "paver/result.h"

namespace paver {

/// Text or binary, as OpenCASCADE or FreeCAD writes it; BREP states no unit.
void read_brep(const FileSource& file, bool is_binary, Shape& shape, ModelReport& report, Progress& progress);

/// Work units of Stage::read.
inline constexpr long read_units = 100;

}  // namespace paver
