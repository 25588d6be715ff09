// Edges and nodes that several ranks hold, put together from what each of them knows.
#pragma once

#include <vector>

#include "paver/mesher.h"
#include "quality/mesh_edges_impl.h"

namespace paver {

/// Of the shared edges and nodes each is in the answer of one rank.
struct SharedFigures {
  std::vector<double> chords;  ///< mm, per edge
  long border = 0, nonmanifold = 0;
  long nodes = 0;  ///< that an element of any rank uses
  long face_interior_nodes = 0, irregular_nodes = 0;
};

/// Collective. `edges`: those of `mesh`, a share. `is_used`, `is_outside`: per node of it, used by an element; on the
/// border by an edge of this rank alone, or on a B-rep edge.
SharedFigures measure_shared(const SurfaceMesh& mesh, const ShareNumbers& numbers, const EdgeFigures& edges,
                             const std::vector<char>& is_used, const std::vector<char>& is_outside, Ranks& ranks);

}  // namespace paver
