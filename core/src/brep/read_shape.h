// Reads a CAD file into an OpenCASCADE shape, in millimetres.
#pragma once

#include <memory>
#include <string>

#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Opaque owner of a TopoDS_Shape and the names its file gives to faces (definition in brep/shape_impl.h).
struct Shape;

/// Reads STEP, IGES or BREP; the format is decided by content, not by the file's ending.
/// Fills file, format, unit of `report`. Throws file_missing, not_a_cad_file, damaged_file, no_faces.
std::shared_ptr<Shape> read_shape(const std::string& path, ModelReport& report, Progress& progress);

}  // namespace paver
