// One reader per format; each gives a shape in millimetres, or throws Error{damaged_file}.
#pragma once

#include "brep/occt_impl.h"
#include "brep/shape_impl.h"
#include "paver/result.h"

namespace paver {

/// `shape.shape` is null when the file has nothing to transfer. Sets `report.unit`.
void read_step(const std::string& path, Shape& shape, ModelReport& report, Progress& progress);
void read_iges(const std::string& path, Shape& shape, ModelReport& report, Progress& progress);
/// Text or binary; BREP states no unit.
void read_brep(const std::string& path, bool is_binary, Shape& shape, ModelReport& report, Progress& progress);

/// Work units of Stage::read.
inline constexpr long read_units = 100;

}  // namespace paver
