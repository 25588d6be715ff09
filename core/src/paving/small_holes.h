// Small holes, cut into the mesh of a region that was paved as if they were not there.
#pragma once

#include <vector>

#include "paving/front/front.h"

namespace paver {

/// Loops that are holes of a few facets, an even number, far enough from all other loops.
std::vector<std::size_t> small_holes(const Region& region);

Region without_holes(const Region& region, const std::vector<std::size_t>& holes);

/// The loops of small holes, or the outermost rings about them, in a mesh.
struct HoleLoops {
  std::vector<std::vector<int>> nodes;          ///< per hole
  std::size_t first_element = 0, elements = 0;  ///< of the rings
};

/// Adds the boundary nodes of the holes, and rings about them, to the mesh of the region without them.
HoleLoops add_holes(const Region& region, RegionMesh& mesh, const std::vector<std::size_t>& holes);

/// Takes the elements about some of the holes out of the front's mesh and starts the front with the void between:
/// about `width` target lengths, at either side of a hole. False where that void is not sound.
bool cut_about(Front& front, const HoleLoops& holes, const std::vector<char>& is_wanted, double width);

/// Per hole whether a triangle is near it, which is not of the rings.
std::vector<char> are_at_triangles(const Region& region, const RegionMesh& mesh, const HoleLoops& holes);

}  // namespace paver
