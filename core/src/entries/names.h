// Edges and points of the mesh under the names that users know.
#pragma once

#include <string>
#include <vector>

#include "paver/options.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

struct EdgeEntities {
  std::vector<int> of_edge;  ///< per edge of the model: its entity
  /// Per entity. The first are the edges of the shape as read, then follow those that dividing and connecting added,
  /// and pieces of an edge that are in another group than its other pieces ("Junction1", "Piece2").
  std::vector<std::string> names, groups;
};

EdgeEntities list_edge_entities(const Model& model);

/// Lines that are of wires, by the edges of the model: before name_edges.
void count_wire_lines(const Model& model, MeshResult& result);

/// Lines and nodes get the edges of the shape as read; in the model's own list there are pieces of these and others.
void name_edges(const Model& model, MeshResult& result);

/// Nodes of the model's points, and a note about those that have none.
void name_points(const Model& model, MeshResult& result);

/// The shortest line of a wire by the wire's radius; after name_edges.
void measure_segments(const Options& options, MeshResult& result);

}  // namespace paver
