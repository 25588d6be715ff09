// How large a face is, and whether it ends anywhere.
#pragma once

#include "topology/model.h"

namespace paver {

/// Diagonal of a box about the face, mm; infinity where nothing of it can be found.
double face_extent(const Model& model, const Face& face);

/// Whether the face has edges other than its own periodic and degenerate ones.
bool has_border(const Model& model, const Face& face);

}  // namespace paver
