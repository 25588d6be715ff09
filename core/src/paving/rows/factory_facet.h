// The factory facet makes the next quad of a row.
#pragma once

#include "paving/rows/row_plan.h"

namespace paver {

/// Lays one quad on facet f. Each side corner is either the neighbour on the front (an end) or granted for a wish.
/// `left` belongs to the start node of f, `right` to its end node; null: end.
/// New front nodes are appended to `new_nodes`. False, and nothing changed, when it does not fit.
bool lay_quad(Front& front, int f, const Wish* left, const Wish* right, int level, std::vector<int>& new_nodes);

}  // namespace paver
