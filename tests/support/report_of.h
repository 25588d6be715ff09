// A whole run on a shape, for tests that look at its mesh or report.
#pragma once

#include <BRepTools.hxx>
#include <string>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"

namespace paver::test {

inline MeshResult mesh_of(const TopoDS_Shape& shape, double size) {
  TemporaryFolder folder;
  std::string path = folder.file("model.brep");
  BRepTools::Write(shape, path.c_str());
  Options options;
  options.size = size;
  Progress progress;
  return mesh_file(path, options, progress);
}

inline RunReport report_of(const TopoDS_Shape& shape, double size) { return mesh_of(shape, size).report; }

}  // namespace paver::test
