// Quads or triangles of a mesh: what serves both need not tell them apart.
#pragma once

#include "paver/result.h"

namespace paver {

/// Of one kind of element. References to the mesh are kept.
struct ElementTable {
  int corners;
  std::size_t stride;  ///< nodes per element
  const std::vector<int>&nodes, &face;

  ElementTable(const SurfaceMesh& mesh, bool is_quad)
      : corners(is_quad ? 4 : 3),
        stride(static_cast<std::size_t>(is_quad ? mesh.nodes_per_quad() : mesh.nodes_per_triangle())),
        nodes(is_quad ? mesh.quads : mesh.triangles),
        face(is_quad ? mesh.quad_face : mesh.triangle_face) {}

  std::size_t count() const { return face.size(); }
  /// Nodes of an element, in Gmsh's order.
  const int* row(std::size_t element) const { return nodes.data() + element * stride; }
};

}  // namespace paver
