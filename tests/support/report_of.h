// A whole run on a shape, for tests that look at its mesh or report.
#pragma once

#include <BRepTools.hxx>
#include <algorithm>
#include <string>

#include "core/brep/shape_files.h"
#include "paver/mesher.h"

namespace paver::test {

inline MeshResult mesh_of(const TopoDS_Shape& shape, const Options& options) {
  TemporaryFolder folder;
  std::string path = folder.file("model.brep");
  BRepTools::Write(shape, path.c_str());
  Progress progress;
  return mesh_file(path, options, progress);
}

inline MeshResult mesh_of(const TopoDS_Shape& shape, double size) {
  Options options;
  options.size = size;
  return mesh_of(shape, options);
}

inline RunReport report_of(const TopoDS_Shape& shape, double size) { return mesh_of(shape, size).report; }

/// Over all faces, mm.
inline double longest_side(const RunReport& report) {
  double longest = 0;
  for (const FaceReport& face : report.faces) longest = std::max(longest, face.longest_side);
  return longest;
}

}  // namespace paver::test
