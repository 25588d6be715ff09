// Whether nodes on B-rep edges lie there.
#pragma once

#include "check/checked_mesh.h"

namespace paver {

/// Of the edges that this rank answers for: faults, and what the sides along them cost of the faces' areas. Nodes are
/// where the edge was divided; a middle that was moved to mend elements lies between its curve and the chord.
void check_boundary_nodes(const CheckedMesh& checked, const Ranks& ranks, MeshFaults& faults, AreaSlack& slack);

}  // namespace paver
