// What edges are called in files: entities of their own, groups.
#pragma once

#include <string>
#include <vector>

#include "topology/model.h"

namespace paver {

struct EdgeEntities {
  std::vector<int> of_edge;  ///< per edge of the model: its entity
  /// Per entity. The first are the edges of the shape as read, then follow those that dividing and connecting added,
  /// and pieces of an edge that are in another group than its other pieces ("Junction1", "Piece2").
  std::vector<std::string> names, groups;
};

EdgeEntities list_edge_entities(const Model& model);

}  // namespace paver
