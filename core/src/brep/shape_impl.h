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
  /// Places in that order of faces that reading had put on the wrong side of their loops, and that were made anew.
  std::vector<int> restored;
  /// Those whose loops reading has turned, so that they are what is left of their surface.
  std::vector<int> turned{};
};

/// Edges that bound no face and vertices that end no edge, in the order of TopExp.
struct LooseShapes {
  explicit LooseShapes(const TopoDS_Shape& shape);
  TopTools_IndexedMapOfShape edges, vertices;
};

}  // namespace paver
