// Parts that all but touch: a solver takes them for apart, an engineer for one.
#pragma once

#include <vector>

#include "check/near/mesh_pieces.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// Largest gap that is told, of the target length or the longest element.
inline constexpr double told_gap = 0.01;

/// Collective: pairs of parts whose elements come nearer than told_gap, by the mesh as it is, each with its least
/// distance, in the order of the model's parts; where they share vertices or edges far nearer and away from these.
/// `pieces`: of the mesh, all that is here of it. Elements that are of, or have nodes of, one part
/// in common say nothing: it is between them, as a thin slab is. Nor do those with a solid between them.
std::vector<Gap> find_gaps(const MeshPieces& pieces, const Model& model, Ranks& ranks);

}  // namespace paver
