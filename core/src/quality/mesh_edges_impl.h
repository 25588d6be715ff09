// Every edge of a mesh once, and what follows from how many elements it has.
#pragma once

#include <vector>

#include "paver/progress.h"
#include "paver/result.h"

namespace paver {

/// An edge between two corner nodes, low < high, and how many elements have it.
struct EdgeUse {
  int low, high, uses;
};

/// Corner nodes of quads and triangles; middle nodes are no part of it.
struct EdgeFigures {
  std::vector<std::vector<double>> chords;  ///< mm, corner to corner, every edge of this rank alone once, in any order
  std::vector<EdgeUse> odd;                 ///< of these the ones that do not have two elements
  std::vector<EdgeUse> shared;              ///< edges whose ends are both shared; no part of the others
  /// Per node: twice the number of edges that meet there, as if all but `odd` had two elements; 0: not a corner.
  std::vector<int> twice_valence;
};

/// `is_shared`: per node, or empty: none. Runs on the threads of the calling arena; the order of what is listed may
/// depend on their number.
EdgeFigures measure_edges(const SurfaceMesh& mesh, const std::vector<char>& is_shared, const Progress& progress);

}  // namespace paver
