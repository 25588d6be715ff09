// Mesh edges that cut a corner of one B-rep edge.
#pragma once

#include "paving/front/front.h"

namespace paver {

/// A chord joins two nodes of one B-rep edge that are not neighbours on it and lies near that edge: along it the mesh
/// would run twice. The two elements beside a chord are divided anew, about a new node where nothing else is good
/// enough. Left alone where no division is positive in the chart and fairly shaped. Returns how many chords went.
int remove_chords(Front& front);

}  // namespace paver
