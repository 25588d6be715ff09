// What a Shape holds; for the files that may see OpenCASCADE.
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/read_shape.h"

namespace paver {

struct Shape {
  TopoDS_Shape shape;
  /// Name the file gives to each face, in the order of TopExp::MapShapes(shape, TopAbs_FACE); empty text where none.
  /// Of a shape that was not read: no names at all.
  std::vector<std::string> labels;
};

}  // namespace paver
