// Parts of a coarse mesh that are paved instead of divided.
#pragma once

#include <vector>

#include "multilevel/fine_mesh.h"
#include "paver/options.h"
#include "paver/progress.h"

namespace paver {

/// Paves, at the fine target length, the marked coarse elements (1 in `is_marked`): those that share a node together,
/// between the fine nodes on their outline. Elements that would leave an outline touching itself are marked, too.
/// Gives the new nodes about poles: best left where they are.
/// To be called before any element is divided to learn which ones are.
void settle_marks(const RegionMesh& mesh, const CoarseNet& net, std::vector<char>& is_marked);
std::vector<int> pave_patches(FineMesh& fine, const std::vector<char>& is_marked, const Progress& progress,
                              Elements elements);

}  // namespace paver
