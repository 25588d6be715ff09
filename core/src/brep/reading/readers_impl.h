// One reader per format; each gives a shape in millimetres, or throws Error{damaged_file}.
#pragma once

#include <functional>
#include <string_view>

#include "brep/occt_impl.h"
#include "brep/reading/read_shape.h"
#include "brep/shape_impl.h"
#include "paver/result.h"

namespace paver {

/// Text or binary, as OpenCASCADE or FreeCAD writes it; BREP states no unit.
void read_brep(const FileSource& file, bool is_binary, Shape& shape, ModelReport& report, Progress& progress);

/// Asks for a trial of a doubtful file.
using Doubt = std::function<void()>;

/// STEP and IGES are read by libraries of their own (formats/), which are loaded with the first such file: they and
/// what they need of OpenCASCADE have half of all the symbols that a program would else look up when it starts. The one
/// function of such a library. `content`: what the file has. `shape.shape` is null when the file has nothing to
/// transfer. Sets `report.unit`. Throws Error{damaged_file}.
extern "C" void paver_read_format(const FileSource& file, std::string_view content, const Doubt& doubt, Shape& shape,
                                  ModelReport& report, Progress& progress);
using FormatReader = decltype(paver_read_format);

/// That of libpaver_`format`.so, beside the program or library that this is part of. Throws Error{internal}.
FormatReader& format_library(const std::string& format, const FileSource& file);

/// Reading in a process that may die, before this one reads: for files that are not as a writer leaves them. Lets
/// another process read a doubtful file and build its topology. Throws what that process refuses the file with,
/// Error{damaged_file} when the CAD kernel breaks down there or comes to no end, Error{out_of_memory}, Error{internal}
/// without the program for it. What else is wrong with the file is for this process to find. Nothing where this process
/// may break down (may_break_down()).
void try_elsewhere(const FileSource& file, const Progress& progress);

/// Work units of Stage::read.
inline constexpr long read_units = 100;

}  // namespace paver
