// A row: the quads laid between two row ends, or around a whole loop.
#pragma once

#include <vector>

#include "paving/rows/node_class.h"
#include "paving/rows/node_placement.h"

namespace paver {

/// Candidate row along `facets`; without ends it runs around the whole loop.
struct Row {
  std::vector<int> facets;
  bool has_ends = true;
  int level = 0;
  bool is_low = true;  ///< neither row next to it in the loop has a lower level
  double cost = 0;     ///< ambiguity of its end nodes
};

/// All rows of the loop between consecutive end nodes, best first: lowest level, clearest ends, shortest. `angles` are
/// those at the ends of its facets.
std::vector<Row> find_rows(const Front& front, const std::vector<int>& loop, const std::vector<double>& angles);

/// Lays the quads of the row until it is done or blocked, and gives their number. Adds the new front nodes.
int lay_row(Front& front, const Row& row, std::vector<int>& new_nodes);

/// Lays one quad on facet f, the factory facet. Each side corner is either the neighbour on the front (an end) or
/// granted for a wish. `left` belongs to the start node of f, `right` to its end node; null: end. New front nodes are
/// appended to `new_nodes`. False, and nothing changed, when it does not fit.
bool lay_quad(Front& front, int f, const Wish* left, const Wish* right, int level, std::vector<int>& new_nodes);

}  // namespace paver
