// Reports of faces: one for each of the model at first, one for each of the shape as read in the end.
#pragma once

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// Fills in the report's faces and their names, one for each of the model's.
void list_faces(const Model& model, const Options& options, MeshResult& result);

/// Faces that dividing and connecting cut become one again: in the mesh, in the reports and in the names.
void merge_pieces(const Model& model, MeshResult& result);

}  // namespace paver
