// Places the nodes of order 2 inside faces: on the surface, found in the charts in which the parts were paved.
#pragma once

#include <vector>

#include "curving/order2.h"
#include "paver/progress.h"
#include "regions/region.h"

namespace paver {

struct CurvedMesh {
  SurfaceMesh mesh;
  std::vector<long> own_nodes;  ///< per part: its own middles and centres
  std::vector<int> cuts;        ///< the cuts whose middles are in the mesh, rising
  int first_inside = 0;         ///< from here on nodes belong to one part only
};

/// The order-2 mesh: middles of B-rep edges as divided, all others the surface point nearest to the middle
/// of the chord, centres the one nearest to the blend of the sides.
CurvedMesh curve_elements(SurfaceMesh linear, const CurvingTask& task, const Progress& progress);

}  // namespace paver
