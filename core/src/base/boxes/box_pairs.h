// Pairs of boxes that meet, by a tree of boxes.
#pragma once

#include <functional>
#include <vector>

#include "base/box.h"

namespace paver {

/// visit(i, j) once for each two of the boxes that meet, in an order that follows from the boxes alone, until it gives
/// false.
void for_meeting(const std::vector<Box>& boxes, const std::function<bool(int i, int j)>& visit);

}  // namespace paver
