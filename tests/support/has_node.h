// Whether a mesh has a node at a place.
#pragma once

#include <algorithm>

#include "paver/mesher.h"

namespace paver::test {

/// Nearer than `within` mm.
inline bool has_node(const SurfaceMesh& mesh, Vec3 place, double within = 1e-6) {
  return std::any_of(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec3 x) { return norm(x - place) < within; });
}

}  // namespace paver::test
