// The fine mesh inside a coarse one.
#pragma once

#include <vector>

#include "multilevel/coarse_net.h"
#include "paver/options.h"
#include "paver/progress.h"
#include "paving/front.h"

namespace paver {

/// Divides each coarse edge into `counts` fine ones and each coarse element into a grid between its edges, triangles in
/// three. Where counts do not fit, fine lengths would be far from their target or a grid is not sound, elements are
/// paved instead, neighbours together. `lengths`: per coarse edge, its length in fine target lengths. `fine` is a front
/// on the fine region with an empty mesh. Every element is positive in the chart. Gives nodes that smoothing should
/// leave alone; nothing, and the mesh is of no use, where much would have to be paved. Throws Error{face_failed} where
/// paving fails.
std::optional<std::vector<int>> subdivide(const CoarseRegion& coarse, const RegionMesh& mesh, const CoarseNet& net,
                                          const std::vector<int>& counts, const std::vector<double>& lengths,
                                          Front& fine, const Progress& progress, Elements elements);

}  // namespace paver
