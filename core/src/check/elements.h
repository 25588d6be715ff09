// Whether elements face the way of their faces and their inner nodes lie on them.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

/// Of this rank: faults, what the turn of each element may cost of its face's area, and, rising, the elements that run
/// against the surface or are farther from it than mending may leave a node.
void check_elements(const CheckedMesh& checked, int threads, const Progress& progress, MeshFaults& faults,
                    AreaSlack& slack);

}  // namespace paver
