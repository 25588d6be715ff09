// A tessellation before it is handed out.
#pragma once

#include <vector>

#include "paver/display.h"

namespace paver {

struct Cut {
  Tessellation shared;
  /// Points of `shared` per element: those of element e follow those of e - 1, each row by row in i.
  std::vector<int> element_points;
};

/// Errors as tessellate.
Cut cut_mesh(const SurfaceMesh& mesh, int subdivision);

}  // namespace paver
