// The regions' meshes become one conforming mesh of order 1.
#pragma once

#include <array>
#include <vector>

#include "boundary/edge_nodes.h"
#include "mesh/region_mesh.h"
#include "topology/model.h"

namespace paver {

/// One paved region. A failed one has no mesh.
struct JoinPart {
  int face = -1;
  const RegionMesh* mesh = nullptr;
};

struct JoinedMesh {
  SurfaceMesh mesh;
  /// Per part and region node: its node in `mesh`, -1 where the region does not use it.
  std::vector<std::vector<int>> node_of;
  /// Per quad: its part, and its element there.
  std::vector<std::array<int, 2>> quad_source;
};

/// Nodes: those of the boundary stage first, then each part's own in order. Elements of reversed faces are turned, so
/// all run counter-clockwise against the outward normal.
/// Throws Error{face_failed} naming the face when an element would use a node twice.
JoinedMesh join_regions(const Model& model, const EdgeNodes& edges, const std::vector<JoinPart>& parts);

}  // namespace paver
