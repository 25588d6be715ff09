// Which parts hang together in the mesh.
#pragma once

#include <string>
#include <vector>

#include "topology/model.h"

namespace paver {

/// Sets of parts whose meshes share nodes, each by name, parts and sets in the order of the model. `entries`: reports
/// of the faces; those that are not meshed hang nothing together.
std::vector<std::vector<std::string>> find_components(const Model& model, const std::vector<FaceReport>& entries);

}  // namespace paver
