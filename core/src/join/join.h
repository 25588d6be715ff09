// The parts' meshes become one conforming mesh of order 1.
#pragma once

#include <vector>

#include "boundary/edge_nodes.h"
#include "regions/region.h"
#include "topology/model.h"

namespace paver {

/// One part of the mesh: a region, or one of the pieces that levels cut it into.
/// Its nodes with `global` >= 0 are shared with others: below the number of nodes of the boundary stage that node, from
/// there on a node on the outlines of its region's pieces.
struct MeshPart {
  const Region* region = nullptr;
  const RegionMesh* mesh = nullptr;           ///< null: failed, or on another rank
  const std::vector<int>* node_of = nullptr;  ///< once it is joined: JoinedMesh's
  int outline = 0;                            ///< number of its region's first outline node among those of all regions
};

/// What a part adds to the mesh.
struct PartSizes {
  long nodes = 0, quads = 0, triangles = 0;
};

/// Where that begins.
struct PartRows {
  int node = 0;
  std::size_t quad = 0, triangle = 0;
};

/// Per part; `node`: the first one that belongs to a part.
std::vector<PartRows> part_rows(const std::vector<PartSizes>& sizes, int node = 0);

/// Per part, for run_tasks().
std::vector<double> part_costs(const std::vector<PartSizes>& sizes);

struct JoinedMesh {
  SurfaceMesh mesh;
  /// Per part and region node: its node in `mesh`, -1 where the region does not use it.
  std::vector<std::vector<int>> node_of;
  std::vector<PartSizes> sizes;  ///< per part
  long boundary_nodes = 0;       ///< nodes of the boundary stage in `mesh`, its first ones
  std::vector<int> outline;      ///< the outline nodes in `mesh`, rising: they follow those of the boundary stage
};

/// What of the boundary stage belongs to a mesh.
struct BoundaryUse {
  std::vector<char> nodes, edges;  ///< per node, per edge
};

struct JoinOptions {
  int outlines = 0;  ///< outline nodes of all regions
  int order = 1;     ///< of the mesh to come: room for the nodes of order 2
  int threads = 1;
};

/// Nodes: those of the boundary stage that are in `use` first, the outline nodes that are used, then each part's own in
/// order. Lines: of the edges in `use`. Points: one per point of the model, -1 where it is no node. Elements of
/// reversed faces are turned, so all run counter-clockwise against the outward normal. Throws Error{face_failed} naming
/// the face when an element would use a node twice.
JoinedMesh join_regions(const Model& model, const EdgeNodes& edges, const BoundaryUse& use,
                        const std::vector<MeshPart>& parts, const JoinOptions& options = {});

/// A node's number among all shared ones: boundary stage, then outlines. `global` >= 0.
inline int shared_node(int global, int outline, std::size_t boundary_nodes) {
  return global < static_cast<int>(boundary_nodes) ? global : global + outline;
}

}  // namespace paver
