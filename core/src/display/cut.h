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

/// Calls add(a, b, c) for the triangles between the points of one element, whose numbers rise row by row in i: rows of
/// n + 1, or of n + 1, n, ..., 1 for a triangle.
template <class Add>
void for_triangles(int n, bool is_quad, Add add) {
  for (int j = 0, row = 0; j < n; ++j) {
    const int length = is_quad ? n + 1 : n + 1 - j, above = row + length;
    for (int i = 0; i + 1 < length; ++i) {
      add(row + i, row + i + 1, above + i);
      if (is_quad || i + 2 < length) add(row + i + 1, above + i + 1, above + i);
    }
    row = above;
  }
}

}  // namespace paver
