// What the mesh itself leaves in doubt: parts that all but touch, elements that run through each other, cracks.
#pragma once

#include "check/near/mesh_pieces.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// Fills in the report's gaps and crossings, none twice and none of parts that it names as unconnected. Collective.
/// `pieces`: of the mesh, all that is here of it.
void find_doubts(const MeshPieces& pieces, const Model& model, Ranks& ranks, RunReport& report);

}  // namespace paver
