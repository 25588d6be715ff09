// Parts of a coarse mesh that are paved instead of divided.
#pragma once

#include <functional>
#include <vector>

#include "multilevel/fine_mesh.h"

namespace paver {

/// Coarse elements (1) whose counts do not fit or whose fine lengths would be far from their target, with room about
/// them: they are paved. `lengths`: per coarse edge, its length in fine target lengths. Empty where much would have to
/// be.
std::vector<char> choose_paved(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                               const std::vector<double>& lengths);

/// Paves the coarse elements of `marked` at the fine target length: those that share a node together, between the fine
/// nodes on their outline, by `pave`. Gives the new nodes about poles: best left where they are.
std::vector<int> pave_patches(FineMesh& fine, const std::vector<int>& marked,
                              const std::function<RegionMesh(const Region&)>& pave);

}  // namespace paver
