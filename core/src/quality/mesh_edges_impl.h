// Every edge of a mesh once, and what follows from how many elements it has.
#pragma once

#include <vector>

#include "paver/result.h"

namespace paver {

/// Corner nodes of quads and triangles; middle nodes are no part of it.
struct EdgeFigures {
  std::vector<double> chords;              ///< mm, corner to corner, every edge once
  long border = 0, nonmanifold = 0;        ///< edges of one element, of more than two
  std::vector<int> valence;                ///< per node: edges that meet there
  std::vector<bool> is_corner, is_border;  ///< per node: used as a corner; on a border edge
};

EdgeFigures measure_edges(const SurfaceMesh& mesh);

}  // namespace paver
