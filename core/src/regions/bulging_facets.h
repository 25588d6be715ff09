// Facets that are to be divided since curved sides there would run over each other, though chords and curves do not.
#pragma once

#include <vector>

#include "paver/vec.h"

namespace paver {

/// A facet of a region's loops in its chart, with the middle node of its side.
struct CurvedFacet {
  Vec2 start, middle, end;
  int first = -1, last = -1;  ///< its nodes, as numbered over all faces
};

/// Of each pair the index of the facet that is to be divided, rising, each once: the one that bulges more where two
/// sides cross; that whose chord the other's side crosses, unless the two face each other end by end, as sides of a
/// quad. Facets with a common node are no pair.
std::vector<int> crowded_facets(const std::vector<CurvedFacet>& facets);

}  // namespace paver
