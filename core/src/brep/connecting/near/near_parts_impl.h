// Which parts may touch.
#pragma once

#include <array>
#include <vector>

#include "brep/connecting/workpiece_impl.h"

namespace paver {

struct NearParts {
  std::vector<std::array<int, 2>> pairs;
  /// Pairs whose free-form faces may touch or cross where at least one part is no solid: for these the kernel's fuse
  /// takes minutes or has no end, so it is not tried.
  std::vector<std::array<int, 2>> free_form;
};

/// Parts that may touch within `tolerance`, by boxes of small pieces of their faces, wires and points.
NearParts find_near_parts(const Workpiece& work, double tolerance);

}  // namespace paver
