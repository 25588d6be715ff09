// The whole job as one call.
#pragma once

#include <string>

#include "paver/options.h"
#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// Reads a STEP, IGES or BREP file and meshes all its faces.
/// A face that fails is named in result.report.faces and the others are delivered.
/// Throws Error for bad input, bad options, cancel and limits.
MeshResult mesh_file(const std::string& path, const Options& options, Progress& progress);

}  // namespace paver
