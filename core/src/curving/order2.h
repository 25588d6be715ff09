// The nodes of order 2, numbered: one more per side and per quad.
#pragma once

#include <array>
#include <vector>

#include "boundary/edge_nodes.h"
#include "join/cuts.h"
#include "join/join.h"

namespace paver {

/// What is to be curved, on so many threads. References are kept.
struct CurvingTask {
  const std::vector<PartSizes>& sizes;  ///< JoinedMesh's
  const EdgeNodes& edges;
  const Model& model;
  const Cuts& cuts;
  const std::vector<MeshPart>& parts;
  int threads = 1;
};

/// Sides of a part's elements. Those inside the part have numbers in the order of first use.
struct PartSides {
  /// Per element and side from corner k: the number of a side inside the part, or -1 - i for `border[i]`.
  std::vector<std::array<int, 4>> of_element;
  std::vector<std::array<int, 2>> inside;  ///< per number: its two region nodes
  std::vector<std::array<int, 2>> border;  ///< sides of one element only: its two region nodes
  std::vector<int> border_node;            ///< per border side: its middle
  std::vector<int> border_cut;             ///< per border side: its cut, or -1
  int first_own = -1;                      ///< the middle of side 0
};

PartSides number_sides(const RegionMesh& mesh);

/// The joined mesh at order 2: nodes of the lines placed, all others numbered only.
/// Nodes: the corners as they were, middles of the lines, of the cuts that are used, then part by part the middles of
/// its own sides and the centres of its quads.
struct OrderTwoMesh {
  SurfaceMesh mesh;
  std::vector<PartSides> sides;  ///< per part
  std::vector<long> own_nodes;   ///< per part: its own middles and centres
  std::vector<int> cut_node;     ///< per cut: its middle, -1 where no part here has it
  int first_inside = 0;          ///< from here on nodes belong to one part only
};

/// A side at a part's border lies on a B-rep edge when its two nodes are the ends of one of the edge's intervals and
/// the edge belongs to its face; else on a cut.
OrderTwoMesh number_order_2(SurfaceMesh linear, const CurvingTask& task);

/// Centre of an order-2 quad that blends its sides: half the sum of the side middles less a quarter of the corners'.
Vec3 blended_centre(const SurfaceMesh& mesh, int quad);

}  // namespace paver
