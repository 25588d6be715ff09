// What a Shape holds; for the files that may see OpenCASCADE.
#pragma once

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "brep/reading/read_shape.h"

namespace paver {

struct Shape {
  TopoDS_Shape shape;
  /// Name the file gives to each face, in the order of TopExp::MapShapes(shape, TopAbs_FACE), then to what is loose:
  /// edges, vertices; empty text where none. Of a shape that was not read: no names at all.
  std::vector<std::string> labels;
  /// Places in that order of faces whose poles reading had lost and got back.
  std::vector<int> restored;
};

/// Edges that bound no face and vertices that end no edge, in the order of TopExp.
struct LooseShapes {
  explicit LooseShapes(const TopoDS_Shape& shape);
  TopTools_IndexedMapOfShape edges, vertices;
};

}  // namespace paver
