// For tests that join parts by hand.
#pragma once

#include "join/join.h"

namespace paver::test {

/// Everything belongs to the mesh.
inline BoundaryUse all_of(const EdgeNodes& edges) {
  return {std::vector<char>(edges.nodes.size(), 1), std::vector<char>(edges.edges.size(), 1)};
}

}  // namespace paver::test
