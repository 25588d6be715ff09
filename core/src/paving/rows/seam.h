// Seams: two facets joined where the front turns back sharply on itself.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// Whether the angle at facet f's end is small enough for a seam: 30 degrees, 50 where many edges meet.
bool wants_seam(const Front& front, int f, double angle);

/// Closes the front at the end of facet f when the angle there is small: the two facets become one mesh edge.
/// Where their lengths differ by more than 2.5 a transition seam divides the longer one first.
/// The loop gets two nodes shorter (transition: stays as long); parity is kept. Returns whether anything changed.
/// Source: [Blacker91, seams], [Owen99] for the transition.
bool close_seam(Front& front, int f);

/// Closes all seams at the given nodes, smallest angle first, again and again until none is left; empties the list.
/// Returns whether anything changed.
bool close_seams(Front& front, std::vector<int>& nodes);

}  // namespace paver
