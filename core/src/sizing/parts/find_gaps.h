// Narrow strips of faces, between edges that face each other.
#pragma once

#include <functional>
#include <vector>

#include "paver/vec.h"
#include "topology/model.h"

namespace paver {

/// A piece of a gap: from a place on one edge straight across to one on the other, and where that is one step on.
struct GapPiece {
  Vec3 from, to;            ///< mm
  Vec3 next_from, next_to;  ///< the same as from and to where the gap ends
  double width = 0;         ///< mm: the lesser one
};

/// Where faces are narrower than 0.7 of their target length, `length(face)`: between edges of one face that run within
/// 30 degrees of each other's direction. Looked for every quarter of the target length.
std::vector<GapPiece> find_gaps(const Model& model, const std::function<double(int face)>& length);

}  // namespace paver
