// Boundary nodes and regions of a model whose loops do not cross.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "boundary/edge_nodes.h"
#include "regions/face_layout.h"
#include "regions/region.h"

namespace paver {

/// A face whose loops cross however finely they are divided, or whose edges come too near to each other.
struct CrossingFace {
  int face = -1;
  std::string reason;
  Vec3 where;
};

struct DividedLoops {
  EdgeNodes nodes;
  std::vector<Region> regions;         ///< of faces that did not fail, in face order
  std::vector<CrossingFace> failures;  ///< in the order in which they were found
};

/// Divides all edges into `counts`, and edges whose facets cross in the chart of a face further, as far as
/// that parts them: only those that leave their chords, and up to most_doublings times. A face whose curves themselves
/// cross fails, as does one where that is not enough; what was divided only for such a face is not.
/// Where sides are curved (`is_curved`) edges are divided up to twice more where these would run over each other.
/// Collective.
DividedLoops divide_loops(const Model& model, const SizeField& size, const std::vector<FaceLayout>& layouts,
                          const EdgeCounts& counts, bool is_curved, SharedTasks& tasks);

}  // namespace paver
