// Raising the worst elements of a finished mesh.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// Puts all nodes on the surface. Then, for every free node of an element whose scaled Jacobian is less than 0.74:
/// pattern search, in the tangent plane, for the place where the worst element about it and its edge lengths are best;
/// the elements that result are taken up again, `rounds` times. Never turns an element over in the chart.
void raise_worst(Front& front, int rounds);

}  // namespace paver
