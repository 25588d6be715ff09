// The mesh of a run with all that tells what it should be.
#pragma once

#include <cmath>
#include <vector>

#include "boundary/edge_nodes.h"
#include "check/area_slack.h"
#include "check/mesh_faults.h"
#include "curving/order2.h"
#include "join/join.h"
#include "paver/mesher.h"
#include "paver/progress.h"
#include "topology/model.h"

namespace paver {

/// How far off surface or curve mending may leave a node, of the target length: a quarter is too much, and between
/// nodes it is more.
constexpr double most_off_moved = 0.12;

/// What sides inside faces and centres may be off the surface at order 1, of the target length of the face. At the
/// limit of 45 degrees per side a sphere's sides are 0.1 off, the centres of its quads 0.2.
constexpr double most_off_side = 0.15;
constexpr double most_off_centre = 0.225;
/// Cosine of 15 degrees, from an element's normal to the surface's at a corner: up to there a side of two target
/// lengths is less than most_off_side off.
constexpr double nearly_flat = 0.966;

/// References are kept. What one rank holds: `mesh` is what the parts that are here were joined to.
struct CheckedMesh {
  const Model& model;
  const EdgeNodes& edges;
  const SurfaceMesh& mesh;
  const std::vector<MeshPart>& parts;
  const std::vector<PartSizes>& sizes;  ///< per part: what of the mesh is its
  const RowNumbers& node_number;
  const std::vector<int>& moved;  ///< middles and centres that were moved to mend elements, rising
  int shared_nodes = 0;           ///< corner nodes before this one may be used by several parts
  std::vector<char> is_meshed{};  ///< per face of the model: its elements are in the mesh
  double target_length = INFINITY;

  long number(int node) const { return node_number[node]; }
  /// Middle between two nodes.
  Vec3 middle(int a, int b) const { return 0.5 * (mesh.nodes[a] + mesh.nodes[b]); }
};

/// Whether elements face the way of their faces and their inner nodes lie on them. Of this rank: faults, and what the
/// turn of each element may cost of its face's area.
void check_elements(const CheckedMesh& checked, int threads, const Progress& progress, MeshFaults& faults,
                    AreaSlack& slack);

/// Whether nodes on B-rep edges lie there. Of the edges that this rank answers for: faults, and what the sides along
/// them cost of the faces' areas. Nodes are where the edge was divided; a middle that was moved to mend elements lies
/// between its curve and the chord.
void check_boundary_nodes(const CheckedMesh& checked, const Ranks& ranks, MeshFaults& faults, AreaSlack& slack);

/// Whether elements fit together; collective, `faults` are those of this rank. Sides inside a face are in two elements
/// that run opposite; those on a B-rep edge in as many elements of each face as that uses the edge there, and in no
/// more than the edge has faces. At order 2 the elements of a side have the same middle. No two elements are the same.
void check_sides(const CheckedMesh& checked, int threads, const Progress& progress, Ranks& ranks, MeshFaults& faults);

}  // namespace paver
