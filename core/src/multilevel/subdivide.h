// Which coarse elements are divided and which are paved.
#pragma once

#include <vector>

#include "multilevel/coarse/coarse_net.h"

namespace paver {

/// Coarse elements (1) whose counts do not fit or whose fine lengths would be far from their target, with room about
/// them: they are paved. `lengths`: per coarse edge, its length in fine target lengths. Empty where much would have to
/// be.
std::vector<char> choose_paved(const RegionMesh& mesh, const CoarseNet& net, const std::vector<int>& counts,
                               const std::vector<double>& lengths);

}  // namespace paver
