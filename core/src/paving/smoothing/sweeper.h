// Smoothing of a finished mesh, all nodes at a time.
#pragma once

#include "paver/progress.h"
#include "paving/front/front.h"

namespace paver {

/// Sweeps over the elements, `sweeps` times or until nothing moves far any more: each fits its best square (equilateral
/// triangle) of the target length, and each free node goes to the mean of the places its elements want it at. A node
/// stays where moving would turn an element over in the chart or make the worst one about it worse than a scaled
/// Jacobian of 0.7 and than it was; after the first sweep only nodes near those that still moved are looked at.
void sweep_nodes(Front& front, int sweeps, const Progress& progress);

}  // namespace paver
