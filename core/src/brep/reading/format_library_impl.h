// STEP and IGES are read by libraries of their own (formats/), which are loaded with the first such file: they and what
// they need of OpenCASCADE have half of all the symbols that a program would else look up when it starts.
#pragma once

#include <functional>
#include <string_view>

#include "brep/reading/read_shape.h"
#include "brep/shape_impl.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Asks for a trial of a doubtful file.
using Doubt = std::function<void()>;

/// The one function of such a library. `content`: what the file has. `shape.shape` is null when the file has nothing to
/// transfer. Sets `report.unit`. Throws Error{damaged_file}.
extern "C" void paver_read_format(const FileSource& file, std::string_view content, const Doubt& doubt, Shape& shape,
                                  ModelReport& report, Progress& progress);
using FormatReader = decltype(paver_read_format);

/// That of libpaver_`format`.so, beside the program or library that this is part of. Throws Error{internal}.
FormatReader& format_library(const std::string& format, const FileSource& file);

}  // namespace paver
