// What users name in a model: parts as read, groups of the mesh, solids with their media.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "topology/model.h"

namespace paver {

/// Throws Error{bad_option} when the model has no such part: "`who` names Face9, but the model has only Face1; ...".
void check_part(const Model& model, const std::string& part, const std::string& who);

/// Whether an entry of the report is the face as read, or what it has in common with others.
bool is_of_face(const Model& model, int entry, int face);

/// Puts the groups of ports and wires, the vertices of ports as points, and the media of solids into the model.
/// Vertices with a length of their own are nodes, too. Throws as check_part.
void name_parts(Model& model, const Options& options);

/// The medium of the first of some parts that has one; empty: of none.
std::string medium_of(const Model& model, const std::vector<int>& parts);

/// How far connecting may have moved a vertex, mm.
double vertex_reach(const Model& model, const Options& options);

}  // namespace paver
