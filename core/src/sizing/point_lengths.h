// Target lengths at points, to be shown before anything is meshed.
#pragma once

#include <vector>

#include "paver/mesher.h"
#include "sizing/size_field.h"

namespace paver {

/// Per point: the least of the faces that the face as read has become there; 0 where none of them will be meshed.
std::vector<double> point_lengths(const Model& model, const SizeField& size, const std::vector<FacePoint>& points);

}  // namespace paver
