// How large a face is.
#pragma once

#include "topology/model.h"

namespace paver {

/// Diagonal of a box about the face, mm; infinity where nothing of it can be found.
double face_extent(const Model& model, const Face& face);

}  // namespace paver
