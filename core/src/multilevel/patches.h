// Parts of a coarse mesh that are paved instead of divided.
#pragma once

#include <functional>
#include <vector>

#include "multilevel/fine_mesh.h"

namespace paver {

/// Marks elements (1 in `is_marked`) that would leave an outline of the marked ones touching itself.
void settle_marks(const RegionMesh& mesh, const CoarseNet& net, std::vector<char>& is_marked);

/// Paves the coarse elements of `marked` at the fine target length: those that share a node together, between the fine
/// nodes on their outline, by `pave`. Gives the new nodes about poles: best left where they are.
std::vector<int> pave_patches(FineMesh& fine, const std::vector<int>& marked,
                              const std::function<RegionMesh(const Region&)>& pave);

}  // namespace paver
