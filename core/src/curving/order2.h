// A straight mesh raised to order 2: one node more per mesh edge and per quad.
#pragma once

#include <functional>
#include <vector>

#include "boundary/edge_nodes.h"
#include "paver/result.h"
#include "topology/model.h"

namespace paver {

/// A mesh edge inside a face, to be given a middle node.
struct InteriorSide {
  int face = -1;
  int a = -1, b = -1;  ///< corner nodes, a < b
  int node = -1;       ///< the middle node
};

/// Mesh of order 2 with all its nodes numbered: corners as they were, middles of the lines, middles of the interior
/// sides (in order of first use: quads, then triangles), centres of the quads in order.
/// Middles of lines are placed; middles of interior sides and centres are not.
struct OrderTwoMesh {
  SurfaceMesh mesh;
  std::vector<InteriorSide> sides;
};

/// `linear`: order 1; its lines run interval by interval along each edge as `edges` divides it.
/// All faces that use an edge share its middles. A side lies on an edge when its two nodes are the ends of one of the
/// edge's intervals and the edge belongs to its face: the same two nodes may be joined otherwise inside another face.
OrderTwoMesh number_order_2(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model);

/// Centre of an order-2 quad that blends its sides: half the sum of the side middles less a quarter of the corners'.
Vec3 blended_centre(const SurfaceMesh& mesh, int quad);

/// Position on the face of the middle between two corner nodes (a < b).
using MidpointFn = std::function<Vec3(int face, int a, int b)>;
/// Position on the face of a quad's centre, given the blended one.
using CentreFn = std::function<Vec3(int quad, Vec3 blend)>;

/// number_order_2 with every node placed. An empty CentreFn leaves the blended centres.
SurfaceMesh raise_to_order_2(const SurfaceMesh& linear, const EdgeNodes& edges, const Model& model,
                             const MidpointFn& midpoint, const CentreFn& centre);

}  // namespace paver
