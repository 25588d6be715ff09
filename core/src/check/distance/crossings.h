// Elements that run through each other: where a sheet or the shell of a body crosses itself.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "check/near/mesh_pieces.h"
#include "paver/ranks.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

using PartPairs = std::vector<std::array<std::string, 2>>;

/// Collective: one place for each two faces, or one, of which elements without a common node run through each other, by
/// the mesh as it is, in the order of the model's faces. Names are those of `model.faces`. Told where a side of one is
/// more than a hundred thousandth of the longer element before and behind the other, or a corner lies that near it at
/// an angle; where elements about there are less than 15 degrees apart, it may be missed. `pieces`: of the mesh, all
/// that is here of it. `told`: parts that are known to lack a connection, about which nothing more is said.
std::vector<Crossing> find_crossings(const MeshPieces& pieces, const Model& model, const PartPairs& told, Ranks& ranks);

}  // namespace paver
