// What users name in a model: parts as read, groups of the mesh, solids with their media; what edges are called in
// files; which parts hang together.
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

/// The solids that have a medium, with the faces that bound them. Pieces of a face that bound it from both sides, and
/// faces inside of it, are left out.
std::vector<Volume> list_volumes(const Model& model);

/// Parts of ports and wires that are not in the mesh under their name: "Edge5 of 'Feed'".
std::vector<std::string> lost_parts(const Options& options, const Model& model, const MeshResult& result);

struct EdgeEntities {
  std::vector<int> of_edge;  ///< per edge of the model: its entity
  /// Per entity. The first are the edges of the shape as read, then follow those that dividing and connecting added,
  /// and pieces of an edge that are in another group than its other pieces ("Junction1", "Piece2").
  std::vector<std::string> names, groups;
};

EdgeEntities list_edge_entities(const Model& model);

/// Sets of parts whose meshes share nodes, each by name, parts and sets in the order of the model. `entries`: reports
/// of the faces; those that are not meshed hang nothing together.
std::vector<std::vector<std::string>> find_components(const Model& model, const std::vector<FaceReport>& entries);

}  // namespace paver
