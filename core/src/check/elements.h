// Whether elements face the way of their faces and their inner nodes lie on them.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

/// Of this rank: faults, and what the turn of each element may cost of its face's area.
void check_elements(const CheckedMesh& checked, int threads, const Progress& progress, MeshFaults& faults,
                    AreaSlack& slack);

}  // namespace paver
