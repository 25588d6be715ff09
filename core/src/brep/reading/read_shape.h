// Reads a CAD file into an OpenCASCADE shape, in millimetres.
#pragma once

#include <memory>
#include <string>

#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Opaque owner of a TopoDS_Shape and the names its file gives to faces (definition in brep/shape_impl.h).
struct Shape;

/// What to open, and what to call it in messages and in the report.
struct FileSource {
  std::string path, name;
  bool is_handed_over = false;  ///< content of a process that has the shape itself, not of a file that may be damaged
};

/// All bytes of a file, as far as they can be read.
std::string content_of(const FileSource& file);

/// Reads STEP, IGES or BREP; the format is decided by content, not by the file's ending.
/// Fills file, format, unit of `report`. Throws file_missing, not_a_cad_file, damaged_file, no_faces.
/// Safe in many threads at once.
std::shared_ptr<Shape> read_shape(const FileSource& file, ModelReport& report, Progress& progress);

inline std::shared_ptr<Shape> read_shape(const std::string& path, ModelReport& report, Progress& progress) {
  return read_shape(FileSource{path, path}, report, progress);
}

}  // namespace paver
