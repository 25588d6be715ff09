// The two long sides of a narrow face, edge for edge.
#pragma once

#include <cmath>

#include "sizing/merging/model_edits.h"

namespace paver {

/// Largest distance of points of either side from the other one; where it is beyond `limit` any such number.
double distance_between(const ModelEdits& edits, const Side& one, const Side& two, double limit = INFINITY);

/// Angle between the planes of two closed sides that run the same way.
double tilt_between(const ModelEdits& edits, const Side& one, const Side& two);

/// Divides edges of both sides until their vertices lie opposite each other. False, and nothing has changed, where
/// those would be farther apart than `most` or would leave edges shorter than it.
bool divide_alike(ModelEdits& edits, Side& one, Side& two, double most);

/// Of each parameter of edge `one` the opposite one of edge `two`, which runs the same way unless `is_against`.
ParameterMatch match_edges(const Edge& one, const Edge& two, bool is_against);

}  // namespace paver
