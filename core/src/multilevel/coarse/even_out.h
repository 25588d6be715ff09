// Even edge lengths in a coarse mesh.
#pragma once

#include <array>
#include <vector>

#include "mesh/region_mesh.h"
#include "paver/progress.h"
#include "regions/region.h"

namespace paver {

/// Moves the free nodes towards least energy of lengths and angles (smooth_grid), in `sweeps` sweeps; nodes of elements
/// that would not be positive in the chart stay. Meshes with triangles stay as they are. `wishes`: per element and side
/// the wished length by the target length, or empty.
void even_out(const Region& region, RegionMesh& mesh, const std::vector<std::array<float, 4>>& wishes, int sweeps,
              const Progress& progress);

}  // namespace paver
