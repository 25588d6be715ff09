// Parts of the shape in the mesh: solids with their media, what is lost, what hangs together.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// The solids that have a medium, with the faces that bound them. Pieces of a face that bound it from both sides, and
/// faces inside of it, are left out.
std::vector<Volume> list_volumes(const Model& model);

/// Parts of ports and wires that are not in the mesh under their name: "Edge5 of 'Feed'".
std::vector<std::string> lost_parts(const Options& options, const Model& model, const MeshResult& result);

/// Sets of parts whose meshes share nodes, each by name, parts and sets in the order of the model. `entries`: reports
/// of the faces; those that are not meshed hang nothing together.
std::vector<std::vector<std::string>> find_components(const Model& model, const std::vector<FaceReport>& entries);

/// Pairs of parts that touch by `contacts` and are of no common set in `components`, though each is of one.
std::vector<std::array<std::string, 2>> contacts_apart(const std::vector<Contact>& contacts,
                                                       const std::vector<std::vector<std::string>>& components);

}  // namespace paver
